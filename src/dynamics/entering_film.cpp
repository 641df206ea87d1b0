#include "dynamics/entering_film.hpp"

#include <algorithm>
#include <cmath>

#include "grid/domain.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<double> near_displacement("entering_near_displacement", 0.05,
                                      "distance of displacements from which an earlier film helps an entering one");
const Tuned<double> near_in_films("entering_near_in_films", 0.1, "the same in expected central films, if that is more");
const Tuned<int> most_iterations("entering_most_iterations", 15,
                                 "Newton iterations to another displacement, before the way to it is halved");
const Tuned<int> most_failures("entering_most_failures", 3,
                               "how often that way is halved before the film is found from nothing");

/// From a film at another displacement, in steps that are halved where Newton's method fails.
std::optional<StationaryResult> displaced(ContactFilm& film, LoadCondition load, SolverOptions options,
                                          FilmSolution from) {
  options.newton.max_iterations = std::min<int>(options.newton.max_iterations, most_iterations);
  const double wanted = load.value;
  double way = wanted - from.H0;
  for (int failures = 0; failures <= most_failures;) {
    const bool last = std::abs(wanted - from.H0) <= std::abs(way) * (1.0 + 1e-9);
    load.value = last ? wanted : from.H0 + way;
    std::optional<StationaryResult> found = improve_stationary(film, load, options, {from.pressure, load.value});
    if (found && last) return found;
    if (found) {
      from = std::move(found->solution);
    } else {
      way *= 0.5;
      ++failures;
    }
  }
  return {};
}

}  // namespace

StationaryResult EnteringFilm::solve(ContactFilm& film, const LoadCondition& load, const SolverOptions& options) {
  const GridShape& shape = film.grid().shape();
  const double near = std::max<double>(near_displacement, near_in_films * ExpectedFilm(film.scales()).film);
  std::optional<StationaryResult> found;
  if (shape == shape_ && std::abs(load.value - last_.H0) < near) found = displaced(film, load, options, last_);
  if (!found) found = solve_stationary(film, load, options);
  shape_ = shape;
  last_ = found->solution;
  return *std::move(found);
}

void EnteringFilm::append_to(std::vector<double>& values) const {
  append(values, shape_);
  values.insert(values.end(), {last_.H0, static_cast<double>(last_.pressure.size())});
  values.insert(values.end(), last_.pressure.begin(), last_.pressure.end());
}

void EnteringFilm::take_from(ValueReader& values) {
  shape_ = values.shape();
  last_.H0 = values.value();
  const std::span<const double> pressure = values.values(values.count());
  last_.pressure.assign(pressure.begin(), pressure.end());
}

}  // namespace gearfilm
