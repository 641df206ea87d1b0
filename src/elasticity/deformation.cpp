#include "elasticity/deformation.hpp"

#include "elasticity/dense_y_convolution.hpp"
#include "elasticity/fft_y_convolution.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
// The kernel is evaluated in double: differences of nearly equal corners.
template <class Real>
Deformation<Real>::Deformation(const Grid& grid, double C_h, std::shared_ptr<const EndFaceCompliance> ends)
    : C_h_(C_h), h_x_(grid.h_x()), rows_(grid.row_axis()), ends_(std::move(ends)), spectra_(grid) {
  const Influence kernel = [this](int i, int j) { return coefficient(i, j); };
  if (!rows_.has_equal_steps() || ends_) {
    const RowInfluence of_rows = [this](int i, int row, int source) { return coefficient(i, row, source); };
    across_ = std::make_unique<DenseYConvolution<Real>>(grid, of_rows, spectra_);
  } else if (DenseYConvolution<Real>::serve(spectra_.waves(), grid.rows())) {
    across_ = std::make_unique<DenseYConvolution<Real>>(grid, kernel, spectra_);
  } else {
    across_ = std::make_unique<FftYConvolution<Real>>(grid, kernel, spectra_);
  }
  if (across_->serves_pairs()) pair_spectra_ = std::make_unique<FieldPairSpectra<Real>>(grid, spectra_.length());
}

// A row of symmetry counts half where it is transformed, and meets its own image.
template <class Real>
double Deformation<Real>::coefficient(int i, int row, int source) const {
  if (rows_.single()) return C_h_ * line_kernel(i * h_x_, h_x_);
  const Strip strip = rows_.strip(source);
  const double y = rows_.y(row);
  double sum = love_kernel(i * h_x_, h_x_, {strip.lower - y, strip.upper - y});
  if (rows_.mirrored()) sum += love_kernel(i * h_x_, h_x_, {-strip.upper - y, -strip.lower - y});
  if (ends_ && i < ends_->lags()) sum += (source == rows_.mirror_row() ? 2.0 : 1.0) * (*ends_)(i, row, source);
  return C_h_ * sum;
}

template <class Real>
void Deformation<Real>::apply(const Field<Real>& pressure, Field<Real>& deformation) const {
  const ScopedEvent event(Kernel::deformation);
  spectra_.transform(pressure);
  across_->apply(spectra_);
  spectra_.transform_back(deformation);
}

template <class Real>
void Deformation<Real>::apply(std::span<const Field<Real>* const> pressures,
                              std::span<Field<Real>* const> deformations) const {
  std::size_t n = 0;
  if (pair_spectra_) {
    const ScopedEvent event(Kernel::deformation);
    for (; n + 1 < pressures.size(); n += 2) {
      pair_spectra_->transform(*pressures[n], *pressures[n + 1]);
      across_->apply(*pair_spectra_);
      pair_spectra_->transform_back(*deformations[n], *deformations[n + 1]);
    }
  }
  for (; n < pressures.size(); ++n) apply(*pressures[n], *deformations[n]);
}

template class Deformation<float>;
template class Deformation<double>;

}  // namespace gearfilm
