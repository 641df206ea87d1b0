#include "gearfilm/parallel/dense_factors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
  petsc_check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
  const PetscErrorCode code = MatLUFactor(factors_, nullptr, nullptr, nullptr);
  petsc_check(PetscPopErrorHandler());
  regular_ = code != PETSC_ERR_MAT_LU_ZRPVT;
  if (regular_) petsc_check(code);
}

std::vector<double> DenseFactors::solve(std::vector<double> right_side) const {
  if (!regular_) return std::vector<double>(right_side.size(), std::numeric_limits<double>::quiet_NaN());
  std::ranges::copy(right_side, VecWriting(right_side_).values().begin());
  petsc_check(MatSolve(factors_, right_side_, solution_));
  std::ranges::copy(VecReading(solution_).values(), right_side.begin());
  return right_side;
}

}  // namespace gearfilm
