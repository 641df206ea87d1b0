#include "gearfilm/ehl/deformation.hpp"

#include <cmath>

#include "gearfilm/ehl/halo.hpp"
#include "gearfilm/parallel/events.hpp"

namespace gearfilm {
namespace {

/// Lines side by side, so that what follows one another in a line is not a power of two apart: a cache has few places
/// for such.
int uneven_stride(int lines) { return lines % 16 == 0 ? lines + 1 : lines; }

/// Lines one after the other that fill FFTW's vectors: it takes a half longer for other numbers.
int full_vectors(int lines) { return (lines + 3) / 4 * 4; }

double love_corner(double x, double y) { return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y)); }

}  // namespace

double love_kernel(double x, double y, double h_x, double h_y) {
  const double x_low = x - 0.5 * h_x, x_high = x + 0.5 * h_x;
  const double y_low = y - 0.5 * h_y, y_high = y + 0.5 * h_y;
  return love_corner(x_high, y_high) - love_corner(x_low, y_high) - love_corner(x_high, y_low) +
         love_corner(x_low, y_low);
}

template <class Real>
Deformation<Real>::Deformation(const Grid& grid, double C_h)
    : comm_(grid.comm()),
      rank_(grid.rank()),
      C_h_(C_h),
      h_x_(grid.h_x()),
      h_y_(grid.h_y()),
      nx_(grid.nx()),
      rows_(grid.rows()),
      own_rows_(grid.y_count()),
      row_begin_(grid.y_begin()),
      pairs_(uneven_stride((own_rows_ + 1) / 2)),
      length_x_(fftw::fast_length(2 * grid.nx() - 3, true)),
      length_y_(fftw::fast_length(2 * (grid.rows() - 1), false)),
      wave_ranges_(cut_evenly(length_x_ / 2 + 1, grid.processes())),
      y_ranges_(grid.y_ranges().begin(), grid.y_ranges().end()),
      x_lines_(static_cast<std::size_t>(length_x_) * pairs_),
      x_waves_(static_cast<std::size_t>(length_x_) * pairs_),
      x_spectrum_(grid.processes() == 1 ? 0 : static_cast<std::size_t>(wave_ranges_.back()) * own_rows_),
      exchanged_(grid.processes() == 1 ? 0 : static_cast<std::size_t>(wave_count()) * rows_),
      y_lines_(static_cast<std::size_t>(full_vectors(wave_count())) * length_y_),
      y_waves_(static_cast<std::size_t>(full_vectors(wave_count())) * length_y_) {
  count_blocks();
  plan_transforms();
  transform_kernel();
}

template <class Real>
void Deformation<Real>::plan_transforms() {
  using Fftw = fftw::Interface<Real>;
  using Raw = typename Fftw::Complex*;
  // Not measured: a measurement may choose differently in the next run, whose results would differ in the last digits.
  constexpr unsigned effort = FFTW_ESTIMATE;
  const auto raw = [](fftw::Buffer<Complex>& buffer) { return reinterpret_cast<Raw>(buffer.data()); };
  const auto plan_x = [&](fftw::Buffer<Complex>& from, int sign) {
    return fftw::Plan<Real>(Fftw::many_c2c(1, &length_x_, pairs_, raw(from), nullptr, pairs_, 1, raw(x_waves_), nullptr,
                                           pairs_, 1, sign, effort));
  };
  const auto plan_y = [&](fftw::Buffer<Complex>& from, int sign) {
    return fftw::Plan<Real>(Fftw::many_c2c(1, &length_y_, full_vectors(wave_count()), raw(from), nullptr, 1, length_y_,
                                           raw(y_waves_), nullptr, 1, length_y_, sign, effort));
  };
  x_forward_ = plan_x(x_lines_, FFTW_FORWARD);
  x_backward_ = plan_x(x_waves_, FFTW_BACKWARD);
  if (wave_count() == 0) return;
  y_forward_ = plan_y(y_lines_, FFTW_FORWARD);
  y_backward_ = plan_y(y_waves_, FFTW_BACKWARD);
}

// The kernel passes through the same distributed transforms in x as a field, with the mirrored half filled in instead
// of zeros. Evaluated in double: differences of nearly equal corners.
template <class Real>
void Deformation<Real>::kernel_to_y_lines(int first) {
  for (int i = 0; i < nx_ - 1; ++i) {
    for (int j = 0; j < own_rows_; ++j) {
      const Real value = static_cast<Real>(coefficient(i, first + row_begin_ + j));
      x_row(i)[j] = value;
      if (i > 0) x_row(length_x_ - i)[j] = value;
    }
  }
  x_forward_.execute();
  separate_rows();
  to_y_lines();
}

template <class Real>
void Deformation<Real>::transform_kernel() {
  const int loaded = rows_ - 1;
  const std::size_t size = static_cast<std::size_t>(wave_count()) * length_y_;
  const Real scale = Real(1.0 / (static_cast<double>(length_x_) * length_y_));
  const auto clear_lines = [&] {
    std::fill_n(x_lines_.data(), static_cast<std::size_t>(length_x_) * pairs_, Complex(0));
    std::fill_n(y_lines_.data(), size, Complex(0));
  };
  clear_lines();  // planning may have written there
  // The distances in y from M on are needed last, and wait where V will be.
  kernel_to_y_lines(loaded);
  mirror_kernel_.assign(y_lines_.data(), y_lines_.data() + size);
  kernel_to_y_lines(0);
  // W, of the distances -M..M.
  for (int k = 0; k < wave_count(); ++k) {
    for (int j = 1; j < loaded; ++j) y_line(k)[length_y_ - j] = y_line(k)[j];
  }
  y_forward_.execute();
  kernel_.resize(size);
  for (std::size_t n = 0; n < size; ++n) kernel_[n] = scale * y_waves_.data()[n].real();
  // V, of the distances 0..2M-1.
  for (int k = 0; k < wave_count(); ++k) {
    const Complex* distant = mirror_kernel_.data() + static_cast<std::size_t>(k) * length_y_;
    std::fill(std::copy_n(distant, loaded, y_line(k) + loaded), y_line(k + 1), Complex(0));
  }
  y_forward_.execute();
  for (std::size_t n = 0; n < size; ++n) mirror_kernel_[n] = scale * y_waves_.data()[n];
  clear_lines();
}

// K being real, V(-n) is the conjugate of V(n).
template <class Real>
void Deformation<Real>::multiply_by_kernel() const {
  for (int k = 0; k < wave_count(); ++k) {
    const std::size_t first = static_cast<std::size_t>(k) * length_y_;
    Complex* line = y_wave(k);
    for (int n = 0; 2 * n <= length_y_; ++n) {
      const int opposite = n == 0 ? 0 : length_y_ - n;
      const Real ar = line[n].real(), ai = line[n].imag(), br = line[opposite].real(), bi = line[opposite].imag();
      const Real w = kernel_[first + n], vr = mirror_kernel_[first + n].real(), vi = mirror_kernel_[first + n].imag();
      line[n] = {w * ar + vr * br - vi * bi, w * ai + vr * bi + vi * br};
      line[opposite] = {w * br + vr * ar + vi * ai, w * bi + vr * ai - vi * ar};
    }
  }
}

template <class Real>
void Deformation<Real>::separate_rows() const {
  for (int k = 0; k <= length_x_ / 2; ++k) {
    const Real* __restrict here = wave_row(k);
    const Real* __restrict mirrored = wave_row((length_x_ - k) % length_x_);
    Real* __restrict out = reinterpret_cast<Real*>(spectrum_before(k));
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
}

template <class Real>
void Deformation<Real>::combine_rows() const {
  for (int k = 0; k <= length_x_ / 2; ++k) {
    const bool own_mirror = k == 0 || 2 * k == length_x_;
    const Real* __restrict in = reinterpret_cast<const Real*>(spectrum_after(k));
    Real* __restrict here = wave_row(k);
    Real* mirrored = own_mirror ? nullptr : wave_row(length_x_ - k);
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
}

template <class Real>
void Deformation<Real>::count_blocks() {
  const int processes = static_cast<int>(wave_ranges_.size()) - 1;
  constexpr int reals = 2;  // of a complex value
  for (int p = 0; p < processes; ++p) {
    x_side_.counts.push_back(reals * (wave_ranges_[p + 1] - wave_ranges_[p]) * own_rows_);
    x_side_.offsets.push_back(reals * wave_ranges_[p] * own_rows_);
    y_side_.counts.push_back(reals * wave_count() * (y_ranges_[p + 1] - y_ranges_[p]));
    y_side_.offsets.push_back(reals * wave_count() * y_ranges_[p]);
  }
}

// Blocks travel as [wave numbers][rows]; on the x side they already lie so, on the y side they are parts of longer
// lines. copy(k, first row, block, rows) moves one piece between the two.
template <class Real>
template <class Copy>
void Deformation<Real>::for_each_block_line(Copy copy) const {
  for (std::size_t p = 0; p + 1 < y_ranges_.size(); ++p) {
    const int first = y_ranges_[p], rows = y_ranges_[p + 1] - first;
    Complex* block = exchanged_.data() + static_cast<std::size_t>(wave_count()) * first;
    for (int k = 0; k < wave_count(); ++k) copy(k, first, block + static_cast<std::size_t>(k) * rows, rows);
  }
}

template <class Real>
void Deformation<Real>::to_y_lines() const {
  if (alone()) return;
  MPI_Alltoallv(x_spectrum_.data(), x_side_.counts.data(), x_side_.offsets.data(), mpi_type<Real>(), exchanged_.data(),
                y_side_.counts.data(), y_side_.offsets.data(), mpi_type<Real>(), comm_);
  for_each_block_line([&](int k, int first, Complex* block, int rows) { std::copy_n(block, rows, y_line(k) + first); });
}

template <class Real>
void Deformation<Real>::to_x_lines() const {
  if (alone()) return;
  for_each_block_line([&](int k, int first, Complex* block, int rows) { std::copy_n(y_wave(k) + first, rows, block); });
  MPI_Alltoallv(exchanged_.data(), y_side_.counts.data(), y_side_.offsets.data(), mpi_type<Real>(), x_spectrum_.data(),
                x_side_.counts.data(), x_side_.offsets.data(), mpi_type<Real>(), comm_);
}

template <class Real>
void Deformation<Real>::apply(const Field<Real>& pressure, Field<Real>& deformation) const {
  const ScopedEvent event(Kernel::deformation);
  for (int i = 1; i < nx_ - 1; ++i) {
    Real* row = x_row(i);
    std::copy_n(pressure.row(i), own_rows_, row);
    if (row_begin_ == 0) row[0] *= Real(0.5);
    if (row_begin_ + own_rows_ == rows_) row[own_rows_ - 1] = Real(0);
  }
  x_forward_.execute();
  separate_rows();
  to_y_lines();
  y_forward_.execute();
  multiply_by_kernel();
  y_backward_.execute();
  to_x_lines();
  combine_rows();
  x_backward_.execute();
  for (int i = 0; i < nx_; ++i) std::copy_n(wave_row(i), own_rows_, deformation.row(i));
}

template class Deformation<float>;
template class Deformation<double>;

}  // namespace gearfilm
