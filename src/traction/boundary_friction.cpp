#include "traction/boundary_friction.hpp"

#include <cmath>

#include "traction/film_line.hpp"

namespace gearfilm {

std::vector<double> boundary_stress(const TractionModel& model, const ContactFilm& film) {
  if (!film.state().rough) return {};
  constexpr double sharp = 1e3;  // of u_s/u_m
  const Grid& grid = film.grid();
  std::vector<double> by_pressure;
  for (const SurfaceVelocities& u : row_velocities(film)) {
    by_pressure.push_back(model.boundary_coefficient * std::tanh(sharp * u.sliding / u.mean) * film.scales().pressure);
  }
  std::vector<double> stress;
  stress.reserve(static_cast<std::size_t>(grid.local_size()));
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      stress.push_back(by_pressure[j] * asperity_pressure(*film.state().rough, film.total_pressure(), i, j));
    }
  }
  return stress;
}

}  // namespace gearfilm
