#include "gearfilm/ehl/deformation.hpp"

#include <cmath>

#include "gearfilm/ehl/halo.hpp"
#include "gearfilm/parallel/events.hpp"

namespace gearfilm {
namespace {

/// Lines side by side, so that what follows one another in a line is not a power of two apart: a cache has few places
/// for such.
int uneven_stride(int lines) { return lines % 16 == 0 ? lines + 1 : lines; }

/// Wave numbers that are transformed in y together: a multiple of FFTW's vectors, and few enough for a cache.
constexpr int bundle = 8;

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
      x_spectrum_(alone() ? 0 : static_cast<std::size_t>(wave_ranges_.back()) * own_rows_),
      exchanged_(alone() ? 0 : static_cast<std::size_t>(wave_count()) * rows_),
      y_lines_(static_cast<std::size_t>(bundle) * length_y_),
      y_waves_(static_cast<std::size_t>(bundle) * length_y_) {
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
  const auto plan_x = [&](int sign) {
    return fftw::Plan<Real>(Fftw::many_c2c(1, &length_x_, pairs_, raw(x_lines_), nullptr, pairs_, 1, raw(x_lines_),
                                           nullptr, pairs_, 1, sign, effort));
  };
  const auto plan_y = [&](fftw::Buffer<Complex>& from, int sign) {
    return fftw::Plan<Real>(Fftw::many_c2c(1, &length_y_, bundle, raw(from), nullptr, 1, length_y_, raw(y_waves_),
                                           nullptr, 1, length_y_, sign, effort));
  };
  x_forward_ = plan_x(FFTW_FORWARD);
  x_backward_ = plan_x(FFTW_BACKWARD);
  y_forward_ = plan_y(y_lines_, FFTW_FORWARD);
  y_backward_ = plan_y(y_waves_, FFTW_BACKWARD);
}

// The kernel passes through the same distributed transforms in x as a field, with the mirrored half filled in instead
// of zeros. Evaluated in double: differences of nearly equal corners.
template <class Real>
void Deformation<Real>::kernel_to_waves(int first) {
  std::fill_n(x_lines_.data(), static_cast<std::size_t>(length_x_) * pairs_, Complex(0));
  for (int i = 0; i < nx_ - 1; ++i) {
    for (int j = 0; j < own_rows_; ++j) {
      const Real value = static_cast<Real>(coefficient(i, first + row_begin_ + j));
      x_row(i)[j] = value;
      if (i > 0) x_row(length_x_ - i)[j] = value;
    }
  }
  to_waves();
}

template <class Real>
void Deformation<Real>::transform_kernel() {
  const int loaded = rows_ - 1, kept = length_y_ / 2 + 1;
  const Real scale = Real(1.0 / (static_cast<double>(length_x_) * length_y_));
  const auto clear_lines = [&] {
    std::fill_n(y_lines_.data(), static_cast<std::size_t>(bundle) * length_y_, Complex(0));
  };
  // The distances in y from M on are needed last.
  kernel_to_waves(loaded);
  std::vector<Complex> distant(static_cast<std::size_t>(wave_count()) * rows_);
  const auto distant_line = [&](int k) { return distant.data() + static_cast<std::size_t>(k) * rows_; };
  for (int k = 0; k < wave_count(); ++k) load(k, distant_line(k));
  kernel_to_waves(0);
  kernel_.resize(kernel_at(wave_count()));
  mirror_kernel_.resize(kernel_at(wave_count()));
  for_each_bundle([&](int first, int count) {
    clear_lines();
    // W, of the distances -M..M.
    for (int n = 0; n < count; ++n) {
      Complex* line = y_line(n);
      load(first + n, line);
      for (int j = 1; j < loaded; ++j) line[length_y_ - j] = line[j];
    }
    y_forward_.execute();
    for (int n = 0; n < count; ++n) {
      Real* kernel = kernel_.data() + kernel_at(first + n);
      for (int m = 0; m < kept; ++m) kernel[m] = scale * y_wave(n)[m].real();
    }
    // V, of the distances 0..2M-1.
    for (int n = 0; n < count; ++n) {
      std::fill(std::copy_n(distant_line(first + n), loaded, y_line(n) + loaded), y_line(n + 1), Complex(0));
    }
    y_forward_.execute();
    for (int n = 0; n < count; ++n) {
      Complex* kernel = mirror_kernel_.data() + kernel_at(first + n);
      for (int m = 0; m < kept; ++m) kernel[m] = scale * y_wave(n)[m];
    }
  });
  clear_lines();
}

// K being real, V(-n) is the conjugate of V(n).
template <class Real>
void Deformation<Real>::multiply_by_kernel(int k, Complex* line) const {
  const Real* kernel = kernel_.data() + kernel_at(k);
  const Complex* mirror_kernel = mirror_kernel_.data() + kernel_at(k);
  for (int n = 0; 2 * n <= length_y_; ++n) {
    const int opposite = n == 0 ? 0 : length_y_ - n;
    const Real ar = line[n].real(), ai = line[n].imag(), br = line[opposite].real(), bi = line[opposite].imag();
    const Real w = kernel[n], vr = mirror_kernel[n].real(), vi = mirror_kernel[n].imag();
    line[n] = {w * ar + vr * br - vi * bi, w * ai + vr * bi + vi * br};
    line[opposite] = {w * br + vr * ar + vi * ai, w * bi + vr * ai - vi * ar};
  }
}

template <class Real>
void Deformation<Real>::separate_rows(int k, Complex* rows) const {
  const Real* __restrict here = x_row(k);
  const Real* __restrict mirrored = x_row((length_x_ - k) % length_x_);
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
void Deformation<Real>::combine_rows(int k, const Complex* rows) const {
  const bool own_mirror = k == 0 || 2 * k == length_x_;
  const Real* __restrict in = reinterpret_cast<const Real*>(rows);
  Real* __restrict here = x_row(k);
  Real* mirrored = own_mirror ? nullptr : x_row(length_x_ - k);
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

template <class Real>
void Deformation<Real>::to_waves() const {
  x_forward_.execute();
  if (alone()) return;
  for (int k = 0; k < wave_ranges_.back(); ++k) separate_rows(k, own_spectrum(k));
  MPI_Alltoallv(x_spectrum_.data(), x_side_.counts.data(), x_side_.offsets.data(), mpi_type<Real>(), exchanged_.data(),
                y_side_.counts.data(), y_side_.offsets.data(), mpi_type<Real>(), comm_);
}

template <class Real>
void Deformation<Real>::from_waves() const {
  if (!alone()) {
    MPI_Alltoallv(exchanged_.data(), y_side_.counts.data(), y_side_.offsets.data(), mpi_type<Real>(),
                  x_spectrum_.data(), x_side_.counts.data(), x_side_.offsets.data(), mpi_type<Real>(), comm_);
    for (int k = 0; k < wave_ranges_.back(); ++k) combine_rows(k, own_spectrum(k));
  }
  x_backward_.execute();
}

// Blocks travel as [wave numbers][rows]; on the x side they already lie so, on the y side they are parts of longer
// lines.
template <class Real>
template <class Move>
void Deformation<Real>::for_each_piece(int k, Move move) const {
  for (std::size_t p = 0; p + 1 < y_ranges_.size(); ++p) {
    const int first = y_ranges_[p], rows = y_ranges_[p + 1] - first;
    move(first, exchanged_.data() + static_cast<std::size_t>(wave_count()) * first + static_cast<std::size_t>(k) * rows,
         rows);
  }
}

template <class Real>
void Deformation<Real>::load(int k, Complex* line) const {
  if (alone()) return separate_rows(k, line);
  for_each_piece(k, [&](int first, const Complex* piece, int rows) { std::copy_n(piece, rows, line + first); });
}

template <class Real>
void Deformation<Real>::store(int k, const Complex* line) const {
  if (alone()) return combine_rows(k, line);
  for_each_piece(k, [&](int first, Complex* piece, int rows) { std::copy_n(line + first, rows, piece); });
}

template <class Real>
template <class Work>
void Deformation<Real>::for_each_bundle(Work work) const {
  for (int first = 0; first < wave_count(); first += bundle) work(first, std::min(bundle, wave_count() - first));
}

template <class Real>
void Deformation<Real>::apply(const Field<Real>& pressure, Field<Real>& deformation) const {
  const ScopedEvent event(Kernel::deformation);
  std::fill(x_row(0), x_row(1), Real(0));
  for (int i = 1; i < nx_ - 1; ++i) {
    Real* row = x_row(i);
    std::fill(std::copy_n(pressure.row(i), own_rows_, row), x_row(i + 1), Real(0));
    if (row_begin_ == 0) row[0] *= Real(0.5);
    if (row_begin_ + own_rows_ == rows_) row[own_rows_ - 1] = Real(0);
  }
  std::fill(x_row(nx_ - 1), x_row(length_x_), Real(0));
  to_waves();
  for_each_bundle([&](int first, int count) {
    for (int n = 0; n < count; ++n) load(first + n, y_line(n));
    y_forward_.execute();
    for (int n = 0; n < count; ++n) multiply_by_kernel(first + n, y_wave(n));
    y_backward_.execute();
    for (int n = 0; n < count; ++n) store(first + n, y_wave(n));
  });
  from_waves();
  for (int i = 0; i < nx_; ++i) std::copy_n(x_row(i), own_rows_, deformation.row(i));
}

template class Deformation<float>;
template class Deformation<double>;

}  // namespace gearfilm
