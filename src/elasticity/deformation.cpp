#include "elasticity/deformation.hpp"

#include <cmath>

#include "elasticity/dense_y_convolution.hpp"
#include "elasticity/fft_y_convolution.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
namespace {

double love_corner(double x, double y) { return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y)); }

}  // namespace

double love_kernel(double x, double y, double h_x, double h_y) {
  const double x_low = x - 0.5 * h_x, x_high = x + 0.5 * h_x;
  const double y_low = y - 0.5 * h_y, y_high = y + 0.5 * h_y;
  return love_corner(x_high, y_high) - love_corner(x_low, y_high) - love_corner(x_high, y_low) +
         love_corner(x_low, y_low);
}

// The kernel is evaluated in double: differences of nearly equal corners.
template <class Real>
Deformation<Real>::Deformation(const Grid& grid, double C_h)
    : C_h_(C_h), h_x_(grid.h_x()), h_y_(grid.h_y()), spectra_(grid) {
  const Influence kernel = [this](int i, int j) { return coefficient(i, j); };
  if (DenseYConvolution<Real>::serve(spectra_.waves(), grid.rows())) {
    across_ = std::make_unique<DenseYConvolution<Real>>(grid, kernel, spectra_);
  } else {
    across_ = std::make_unique<FftYConvolution<Real>>(grid, kernel, spectra_);
  }
}

template <class Real>
void Deformation<Real>::apply(const Field<Real>& pressure, Field<Real>& deformation) const {
  const ScopedEvent event(Kernel::deformation);
  spectra_.transform(pressure);
  across_->apply(spectra_);
  spectra_.transform_back(deformation);
}

template class Deformation<float>;
template class Deformation<double>;

}  // namespace gearfilm
