// How far a stationary film may be from that of an infinitely fine grid.
//
// The same film on every second node of the grid differs from it by three times as much, since errors are of second
// order: e = (h(h) - h(2h))/3 is the estimate of the error, h(h) + e the extrapolated value. A film that was found from
// every second node has been there; else the estimate costs another solution there.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "gearfilm/ehl/stationary.hpp"

namespace gearfilm {

/// A figure with its bar.
struct Estimate {
  double value = 0.0;
  double error = 0.0;  ///< of the value, absolute
  double extrapolated = 0.0;

  /// To the extrapolated value, or to `least` where that is larger.
  double relative_error(double least = 0.0) const { return error / std::max(std::abs(extrapolated), least); }
};

/// Of a figure on a grid, and on one of `ratio` times the steps.
inline Estimate estimate(double fine, double coarse, double ratio = 2.0) {
  const double difference = (fine - coarse) / (ratio * ratio - 1.0);
  return {fine, std::abs(difference), fine + difference};
}

struct GridErrors {
  Estimate central_film;
  Estimate smallest_film;
  Estimate central_pressure;
  Estimate largest_pressure;

  /// Relative, of the two films.
  double worst() const { return std::max(central_film.relative_error(), smallest_film.relative_error()); }
};

/// What a film on the coarser grid becomes with what else acts on it, such as its heat. May throw SolveError.
using CoarseCoupling = std::function<StationaryResult(ContactFilm& coarse, const StationaryResult& alone)>;

/// Of the film that was found under the load condition, and coupled; free of cost where it was found from the coarser
/// grid. Nothing where the grid has no coarser one, or this no film that is positive. Collective.
std::optional<GridErrors> grid_errors(const ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                                      const StationaryResult& result, const CoarseCoupling& couple = {});

}  // namespace gearfilm
