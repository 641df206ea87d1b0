#include "elasticity/x_spectra.hpp"

namespace gearfilm {

template <class Real>
XSpectra<Real>::XSpectra(const Grid& grid)
    : nx_(grid.nx()),
      own_rows_(grid.y_count()),
      inner_(grid.inner_rows()),
      mirror_row_(grid.mirror_row()),
      pairs_(uneven_stride((own_rows_ + 1) / 2)),
      length_(LineTransforms<Real>::fast_length(2 * grid.nx() - 3)),
      lines_(static_cast<std::size_t>(length_) * pairs_),
      transforms_(lines_.data(), length_, pairs_) {}

template <class Real>
void XSpectra<Real>::transform(const Field<Real>& field) {
  std::fill(line(0), line(1), Real(0));
  for (int i = 1; i < nx_ - 1; ++i) {
    Real* row = line(i);
    std::fill(std::copy_n(field.row(i), own_rows_, row), line(i + 1), Real(0));
    if (mirror_row_ >= 0) row[mirror_row_] *= Real(0.5);
    std::fill(row, row + inner_.begin, Real(0));
    std::fill(row + inner_.end, row + own_rows_, Real(0));
  }
  std::fill(line(nx_ - 1), line(length_), Real(0));
  transforms_.forward();
}

template <class Real>
void XSpectra<Real>::separate(int k, Complex* rows) const {
  const Real* __restrict here = wave(k);
  const Real* __restrict mirrored = wave(k == 0 ? 0 : length_ - k);
  Real* __restrict out = reinterpret_cast<Real*>(rows);
  const int whole = own_rows_ / 2;
  for (int m = 0; m < whole; ++m) {
    const Real ar = here[2 * m], ai = here[2 * m + 1], br = mirrored[2 * m], bi = mirrored[2 * m + 1];
    out[4 * m] = Real(0.5) * (ar + br);
    out[4 * m + 1] = Real(0.5) * (ai - bi);
    out[4 * m + 2] = Real(0.5) * (ai + bi);
    out[4 * m + 3] = Real(0.5) * (br - ar);
  }
  if (own_rows_ % 2 == 1) {
    out[4 * whole] = Real(0.5) * (here[2 * whole] + mirrored[2 * whole]);
    out[4 * whole + 1] = Real(0.5) * (here[2 * whole + 1] - mirrored[2 * whole + 1]);
  }
}

template <class Real>
void XSpectra<Real>::combine(int k, const Complex* rows) {
  const bool own_mirror = k == 0 || 2 * k == length_;
  const Real* __restrict in = reinterpret_cast<const Real*>(rows);
  Real* __restrict here = wave(k);
  Real* mirrored = own_mirror ? nullptr : wave(length_ - k);
  const auto combine = [&](int m, Real ar, Real ai, Real br, Real bi) {
    here[2 * m] = ar - bi;
    here[2 * m + 1] = ai + br;
    if (own_mirror) return;
    mirrored[2 * m] = ar + bi;
    mirrored[2 * m + 1] = br - ai;
  };
  const int whole = own_rows_ / 2;
  for (int m = 0; m < whole; ++m) combine(m, in[4 * m], in[4 * m + 1], in[4 * m + 2], in[4 * m + 3]);
  if (own_rows_ % 2 == 1) combine(whole, in[4 * whole], in[4 * whole + 1], Real(0), Real(0));
}

template <class Real>
void XSpectra<Real>::transform_back(Field<Real>& field) {
  transforms_.backward();
  for (int i = 0; i < nx_; ++i) std::copy_n(line(i), own_rows_, field.row(i));
}

template class XSpectra<float>;
template class XSpectra<double>;

}  // namespace gearfilm
