#include "gearfilm/ehl/body_equations.hpp"

#include <numeric>

namespace gearfilm {

double BodyEquations::displaced(std::span<const double> scalars) const {
  return std::inner_product(scalars.begin(), scalars.end(), displacement.begin(), 0.0);
}

std::vector<double> BodyEquations::rows(std::span<const double> scalars, std::span<const double> rates,
                                        double force_sum, Of of) const {
  const std::size_t m = size();
  std::vector<double> rows(m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) rows[i] += mass[i * m + j] * rates[j] + stiffness[i * m + j] * scalars[j];
    rows[i] += (of == Of::states ? constant[i] : 0.0) - force[i] * force_sum;
  }
  return rows;
}

std::vector<double> body_matrix(const BodyEquations& bodies, double shift, double film_stiffness) {
  const std::size_t m = bodies.size();
  std::vector<double> matrix(m * m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      matrix[i * m + j] = shift * bodies.mass[i * m + j] + bodies.stiffness[i * m + j] +
                          film_stiffness * bodies.force[i] * bodies.displacement[j];
    }
  }
  return matrix;
}

BodyEquations fixed_approach(double H0) {
  return {.mass = {0.0}, .stiffness = {1.0}, .force = {0.0}, .constant = {-H0}, .displacement = {1.0}};
}

BodyEquations load_balance(double force) {
  return {.mass = {0.0}, .stiffness = {0.0}, .force = {1.0 / force}, .constant = {1.0}, .displacement = {1.0}};
}

BodyEquations equation_of_motion(double inertia, double static_force, double share, double pressing) {
  return {.mass = {1.0, 0.0, 0.0, inertia / static_force},
          .stiffness = {0.0, -1.0, 0.0, 0.0},
          .force = {0.0, 1.0 / (share * static_force)},
          .constant = {0.0, 1.0 + pressing / static_force},
          .displacement = {1.0, 0.0}};
}

}  // namespace gearfilm
