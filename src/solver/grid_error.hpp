// How far a stationary film may be from that of an infinitely fine grid.
//
// The same film on every second node of the grid tells that (estimate.hpp). A film that was found from every second
// node has been there; else the estimate costs another solution there. A fitted film that every second node does not
// carry is compared with that on every second line. Over a face, whose coarser grids have all its rows, the smallest
// film has at least the bar by which the nearer row beside it differs.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>

#include "numerics/estimate.hpp"
#include "solver/stationary.hpp"

namespace gearfilm {

struct GridErrors {
  Estimate central_film;
  Estimate smallest_film;
  Estimate central_pressure;
  Estimate largest_pressure;
  std::optional<Estimate> spike_pressure;  ///< nothing without a spike

  /// Relative bars of the two films, the larger one.
  double worst() const { return std::max(central_film.relative_error(), smallest_film.relative_error()); }
  /// The same of what is left to their extrapolated values: what the choice of grids aims at.
  double left() const { return std::max(central_film.relative_rest(), smallest_film.relative_rest()); }
};

/// What a film on the coarser grid becomes with what else acts on it, such as its heat. May throw SolveError.
using CoarseCoupling = std::function<StationaryResult(ContactFilm& coarse, const StationaryResult& alone)>;

/// Errors of a film that was found under the load condition, and coupled. They cost nothing where the film was found
/// from the coarser grid. Nothing where there is no coarser grid, or no positive film on it. Collective.
std::optional<GridErrors> grid_errors(const ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                                      const StationaryResult& result, const CoarseCoupling& couple = {});

}  // namespace gearfilm
