#include "elasticity/field_pair_spectra.hpp"

namespace gearfilm {

template <class Real>
FieldPairSpectra<Real>::FieldPairSpectra(const Grid& grid, int length)
    : nx_(grid.nx()),
      own_rows_(grid.y_count()),
      stride_(uneven_stride(own_rows_)),
      inner_(grid.inner_rows()),
      mirror_row_(grid.mirror_row()),
      length_(length),
      lines_(static_cast<std::size_t>(length_) * stride_),
      transforms_(lines_.data(), length_, stride_) {}

template <class Real>
void FieldPairSpectra<Real>::transform(const Field<Real>& real, const Field<Real>& imaginary) {
  std::fill(line(0), line(1), Complex(0));
  for (int i = 1; i < nx_ - 1; ++i) {
    const Real *re = real.row(i), *im = imaginary.row(i);
    Real* row = reinterpret_cast<Real*>(line(i));
    for (int j = 0; j < own_rows_; ++j) {
      row[2 * j] = re[j];
      row[2 * j + 1] = im[j];
    }
    if (mirror_row_ >= 0) line(i)[mirror_row_] *= Real(0.5);
    std::fill(line(i), line(i) + inner_.begin, Complex(0));
    std::fill(line(i) + inner_.end, line(i + 1), Complex(0));
  }
  std::fill(line(nx_ - 1), line(length_), Complex(0));
  transforms_.forward();
}

template <class Real>
void FieldPairSpectra<Real>::transform_back(Field<Real>& real, Field<Real>& imaginary) {
  transforms_.backward();
  for (int i = 0; i < nx_; ++i) {
    const Real* row = reinterpret_cast<const Real*>(line(i));
    Real *re = real.row(i), *im = imaginary.row(i);
    for (int j = 0; j < own_rows_; ++j) {
      re[j] = row[2 * j];
      im[j] = row[2 * j + 1];
    }
  }
}

template class FieldPairSpectra<float>;
template class FieldPairSpectra<double>;

}  // namespace gearfilm
