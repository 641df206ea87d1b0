#include "dynamics/entering_film.hpp"

#include <cmath>

#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<double> near_displacement("entering_near_displacement", 0.05,
                                      "distance of displacements from which an earlier film helps an entering one");

}  // namespace

StationaryResult EnteringFilm::solve(ContactFilm& film, const LoadCondition& load, const SolverOptions& options) {
  const GridShape& shape = film.grid().shape();
  std::optional<StationaryResult> found;
  if (shape == shape_ && std::abs(load.value - last_.H0) < near_displacement) {
    found = improve_stationary(film, load, options, {last_.pressure, load.value});
  }
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
