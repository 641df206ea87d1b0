#include "film/deformation_between_rows.hpp"

#include <cmath>
#include <utility>

namespace gearfilm {

template <class Real>
DeformationBetweenRows<Real>::DeformationBetweenRows(const Grid& grid, const Deformation<PartOf<Real>>& deformation)
    : comm_(grid.comm()),
      own_{grid.y_begin(), grid.y_begin() + grid.y_count()},
      count_(grid.rows()),
      compliance_(static_cast<std::size_t>(count_) * count_),
      responses_(grid) {
  const int apart = static_cast<int>(std::lround(1.0 / grid.h_x()));
  for (int row = 0; row < count_; ++row) {
    for (int source = 0; source < count_; ++source) {
      if (source == row) continue;
      const double images = source == grid.row_axis().mirror_row() ? 2.0 : 1.0;
      compliance(row, source) = static_cast<Part>(deformation.coefficient(apart, row, source) / images);
    }
  }
}

template <class Real>
std::vector<Real> DeformationBetweenRows<Real>::sums(const Field<Real>& field) const {
  std::vector<Real> sums(count_, Real(0));
  for (int i = 0; i < field.nx(); ++i) {
    for (int j = 0; j < own_.count(); ++j) sums[own_.begin + j] += field.row(i)[j];
  }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), count_, mpi_type<Real>(), MPI_SUM, comm_);
  return sums;
}

template <class Real>
void DeformationBetweenRows<Real>::factor(Field<Real> responses) {
  responses_ = std::move(responses);
  const std::vector<Real> stiffness = sums(responses_);
  std::vector<Real> matrix(RowFactors<Real>::entries(count_));
  for (int source = 0; source < count_; ++source) {
    Real* column = matrix.data() + source * RowFactors<Real>::stride(count_);
    for (int row = 0; row < count_; ++row) {
      column[row] = Real(row == source ? 1 : 0) + compliance(row, source) * stiffness[source];
    }
  }
  factors_.compute(matrix, count_);
}

template <class Real>
void DeformationBetweenRows<Real>::correct(Field<Real>& change) {
  const std::vector<Real> loads = sums(change);
  std::vector<Real> displaced(RowFactors<Real>::stride(count_), Real(0));
  for (int source = 0; source < count_; ++source) {
    for (int row = 0; row < count_; ++row) displaced[row] += compliance(row, source) * loads[source];
  }
  factors_.solve(displaced.data());
  for (int i = 0; i < change.nx(); ++i) {
    for (int j = 0; j < own_.count(); ++j) change.row(i)[j] -= responses_.row(i)[j] * displaced[own_.begin + j];
  }
}

template class DeformationBetweenRows<float>;
template class DeformationBetweenRows<double>;
template class DeformationBetweenRows<std::complex<double>>;

}  // namespace gearfilm
