// A small dense linear system, solved by every process for itself.
#pragma once

#include <vector>

#include "gearfilm/parallel/petsc.hpp"

namespace gearfilm {

class DenseFactors {
public:
  /// Of a square matrix, row by row.
  void factor(const std::vector<double>& matrix);
  /// One value a row; NaN where the matrix is singular, which PETSc's solvers take for a failed solve.
  std::vector<double> solve(std::vector<double> right_side) const;

private:
  OwnedMat factors_;
  OwnedVec right_side_, solution_;
  std::size_t size_ = 0;
  bool regular_ = true;
};

}  // namespace gearfilm
