#include "gearfilm/ehl/border.hpp"

#include <algorithm>
#include <numeric>

namespace gearfilm {

double Border::displaced(std::span<const double> scalars) const {
  return std::inner_product(scalars.begin(), scalars.end(), displacement.begin(), 0.0);
}

std::vector<double> Border::rows(std::span<const double> scalars, std::span<const double> rates, double force_sum,
                                 Of of) const {
  const std::size_t m = size();
  std::vector<double> rows(m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) rows[i] += mass[i * m + j] * rates[j] + stiffness[i * m + j] * scalars[j];
    rows[i] += (of == Of::states ? constant[i] : 0.0) - force[i] * force_sum;
  }
  return rows;
}

BorderFactors::BorderFactors(std::size_t scalars) {
  const auto m = static_cast<PetscInt>(scalars);
  petsc_check(MatCreateSeqDense(PETSC_COMM_SELF, m, m, nullptr, factors_.put()));
  petsc_check(MatCreateVecs(factors_, solution_.put(), right_side_.put()));
}

void BorderFactors::factor(const Border& border, double shift, double film_stiffness) {
  const auto m = static_cast<PetscInt>(border.size());
  petsc_check(MatSetUnfactored(factors_));
  for (PetscInt i = 0; i < m; ++i) {
    for (PetscInt j = 0; j < m; ++j) {
      const double entry = shift * border.mass[i * m + j] + border.stiffness[i * m + j] +
                           film_stiffness * border.force[i] * border.displacement[j];
      petsc_check(MatSetValue(factors_, i, j, entry, INSERT_VALUES));
    }
  }
  petsc_check(MatAssemblyBegin(factors_, MAT_FINAL_ASSEMBLY));
  petsc_check(MatAssemblyEnd(factors_, MAT_FINAL_ASSEMBLY));
  petsc_check(MatLUFactor(factors_, nullptr, nullptr, nullptr));
}

std::vector<double> BorderFactors::solve(std::vector<double> rows) const {
  std::ranges::copy(rows, VecWriting(right_side_).values().begin());
  petsc_check(MatSolve(factors_, right_side_, solution_));
  std::ranges::copy(VecReading(solution_).values(), rows.begin());
  return rows;
}

Border given_displacement(double H0) {
  return {.mass = {0.0}, .stiffness = {1.0}, .force = {0.0}, .constant = {-H0}, .displacement = {1.0}};
}

Border given_force(double force) {
  return {.mass = {0.0}, .stiffness = {0.0}, .force = {1.0 / force}, .constant = {1.0}, .displacement = {1.0}};
}

Border rigid_pair(double inertia, double static_force, double share) {
  return {.mass = {1.0, 0.0, 0.0, inertia / static_force},
          .stiffness = {0.0, -1.0, 0.0, 0.0},
          .force = {0.0, 1.0 / (share * static_force)},
          .constant = {0.0, 1.0},
          .displacement = {1.0, 0.0}};
}

}  // namespace gearfilm
