#include "gearfilm/parallel/dense_factors.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {

void DenseFactors::factor(const std::vector<double>& matrix) {
  const auto size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
  const auto m = static_cast<PetscInt>(size);
  if (size != size_) {
    petsc_check(MatCreateSeqDense(PETSC_COMM_SELF, m, m, nullptr, factors_.put()));
    petsc_check(MatCreateVecs(factors_, solution_.put(), right_side_.put()));
    size_ = size;
  }
  petsc_check(MatSetUnfactored(factors_));
  for (PetscInt i = 0; i < m; ++i) {
    for (PetscInt j = 0; j < m; ++j) petsc_check(MatSetValue(factors_, i, j, matrix[i * m + j], INSERT_VALUES));
  }
  petsc_check(MatAssemblyBegin(factors_, MAT_FINAL_ASSEMBLY));
  petsc_check(MatAssemblyEnd(factors_, MAT_FINAL_ASSEMBLY));
  petsc_check(MatLUFactor(factors_, nullptr, nullptr, nullptr));
}

std::vector<double> DenseFactors::solve(std::vector<double> right_side) const {
  std::ranges::copy(right_side, VecWriting(right_side_).values().begin());
  petsc_check(MatSolve(factors_, right_side_, solution_));
  std::ranges::copy(VecReading(solution_).values(), right_side.begin());
  return right_side;
}

}  // namespace gearfilm
