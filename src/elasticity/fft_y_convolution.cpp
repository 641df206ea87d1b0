#include "elasticity/fft_y_convolution.hpp"

#include "grid/halo.hpp"

namespace gearfilm {
namespace {

/// Wave numbers that are transformed in y together: a multiple of FFTW's vectors, and few enough for a cache.
constexpr int bundle = 8;

/// The smallest 2^a, 3 2^a or 5 2^a >= n with a >= 4: of lines one behind another FFTW's estimated plans are fast for
/// these, and take two to three times as long for most lengths between them.
int padded_length(int n) {
  const auto fitting = [n](int length) {
    while (length < n) length *= 2;
    return length;
  };
  return std::min({fitting(16), fitting(3 * 16), fitting(5 * 16)});
}

}  // namespace

template <class Real>
FftYConvolution<Real>::FftYConvolution(const Grid& grid, const Influence& kernel, XSpectra<Real>& spectra)
    : comm_(grid.comm()),
      rank_(grid.rank()),
      rows_(grid.rows()),
      sources_(grid.row_axis().inner({0, rows_}).end),
      mirrored_(grid.row_axis().mirrored()),
      own_rows_(grid.y_count()),
      row_begin_(grid.y_begin()),
      length_(padded_length(2 * sources_)),
      wave_ranges_(cut_evenly(spectra.waves(), grid.processes())),
      y_ranges_(grid.y_ranges().begin(), grid.y_ranges().end()),
      spectrum_(alone() ? 0 : static_cast<std::size_t>(wave_ranges_.back()) * own_rows_),
      exchanged_(alone() ? 0 : static_cast<std::size_t>(wave_count()) * rows_),
      lines_(static_cast<std::size_t>(bundle) * length_),
      waves_(static_cast<std::size_t>(bundle) * length_) {
  count_blocks();
  plan_transforms();
  transform_kernel(kernel, spectra);
}

template <class Real>
void FftYConvolution<Real>::plan_transforms() {
  using Fftw = fftw::Interface<Real>;
  using Raw = typename Fftw::Complex*;
  const auto raw = [](fftw::Buffer<Complex>& buffer) { return reinterpret_cast<Raw>(buffer.data()); };
  const auto plan = [&](fftw::Buffer<Complex>& from, int sign) {
    return fftw::Plan<Real>(Fftw::many_c2c(1, &length_, bundle, raw(from), nullptr, 1, length_, raw(waves_), nullptr, 1,
                                           length_, sign, fftw::effort));
  };
  forward_ = plan(lines_, FFTW_FORWARD);
  backward_ = plan(waves_, FFTW_BACKWARD);
}

// The kernel passes through the same distributed transforms as a field, with the mirrored half filled in instead of
// zeros.
template <class Real>
void FftYConvolution<Real>::transform_kernel(const Influence& kernel, XSpectra<Real>& spectra) {
  const int kept = length_ / 2 + 1;
  const Real scale = Real(1.0 / (static_cast<double>(spectra.length()) * length_));
  const auto clear_lines = [&] { std::fill_n(lines_.data(), static_cast<std::size_t>(bundle) * length_, Complex(0)); };
  const auto gather_kernel = [&](int first) {
    spectra.transform_even([&](int i, int j) { return kernel(i, first + row_begin_ + j); });
    gather(spectra);
  };
  // The distances in y from M on are needed last, and by V alone.
  std::vector<Complex> distant(mirrored_ ? static_cast<std::size_t>(wave_count()) * rows_ : 0);
  const auto distant_line = [&](int k) { return distant.data() + static_cast<std::size_t>(k) * rows_; };
  if (mirrored_) {
    gather_kernel(sources_);
    for (int k = 0; k < wave_count(); ++k) load(spectra, k, distant_line(k));
  }
  gather_kernel(0);
  kernel_.resize(kernel_at(wave_count()));
  mirror_kernel_.resize(mirrored_ ? kernel_.size() : 0);
  for_each_bundle([&](int first, int count) {
    clear_lines();
    // W, of the distances -M..M.
    for (int n = 0; n < count; ++n) {
      load(spectra, first + n, line(n));
      for (int j = 1; j < sources_; ++j) line(n)[length_ - j] = line(n)[j];
    }
    forward_.execute();
    for (int n = 0; n < count; ++n) {
      Real* transform = kernel_.data() + kernel_at(first + n);
      for (int m = 0; m < kept; ++m) transform[m] = scale * wave(n)[m].real();
    }
    if (!mirrored_) return;
    // V, of the distances 0..2M-1.
    for (int n = 0; n < count; ++n) {
      std::fill(std::copy_n(distant_line(first + n), sources_, line(n) + sources_), line(n + 1), Complex(0));
    }
    forward_.execute();
    for (int n = 0; n < count; ++n) {
      Complex* transform = mirror_kernel_.data() + kernel_at(first + n);
      for (int m = 0; m < kept; ++m) transform[m] = scale * wave(n)[m];
    }
  });
  clear_lines();
}

// K being real, V(-n) is the conjugate of V(n).
template <class Real>
void FftYConvolution<Real>::multiply_by_kernel(int k, Complex* line) const {
  const Real* kernel = kernel_.data() + kernel_at(k);
  if (!mirrored_) {
    for (int n = 0; n < length_; ++n) line[n] *= kernel[std::min(n, length_ - n)];
    return;
  }
  const Complex* mirror_kernel = mirror_kernel_.data() + kernel_at(k);
  for (int n = 0; 2 * n <= length_; ++n) {
    const int opposite = n == 0 ? 0 : length_ - n;
    const Real ar = line[n].real(), ai = line[n].imag(), br = line[opposite].real(), bi = line[opposite].imag();
    const Real w = kernel[n], vr = mirror_kernel[n].real(), vi = mirror_kernel[n].imag();
    line[n] = {w * ar + vr * br - vi * bi, w * ai + vr * bi + vi * br};
    line[opposite] = {w * br + vr * ar + vi * ai, w * bi + vr * ai - vi * ar};
  }
}

template <class Real>
void FftYConvolution<Real>::count_blocks() {
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
void FftYConvolution<Real>::gather(const XSpectra<Real>& spectra) {
  if (alone()) return;
  for (int k = 0; k < wave_ranges_.back(); ++k) spectra.separate(k, own_spectrum(k));
  MPI_Alltoallv(spectrum_.data(), x_side_.counts.data(), x_side_.offsets.data(), mpi_type<Real>(), exchanged_.data(),
                y_side_.counts.data(), y_side_.offsets.data(), mpi_type<Real>(), comm_);
}

template <class Real>
void FftYConvolution<Real>::scatter(XSpectra<Real>& spectra) {
  if (alone()) return;
  MPI_Alltoallv(exchanged_.data(), y_side_.counts.data(), y_side_.offsets.data(), mpi_type<Real>(), spectrum_.data(),
                x_side_.counts.data(), x_side_.offsets.data(), mpi_type<Real>(), comm_);
  for (int k = 0; k < wave_ranges_.back(); ++k) spectra.combine(k, own_spectrum(k));
}

// Blocks travel as [wave numbers][rows]; on the x side they already lie so, on the y side they are parts of longer
// lines.
template <class Real>
template <class Move>
void FftYConvolution<Real>::for_each_piece(int k, Move move) const {
  for (std::size_t p = 0; p + 1 < y_ranges_.size(); ++p) {
    const int first = y_ranges_[p], rows = y_ranges_[p + 1] - first;
    move(first, static_cast<std::size_t>(wave_count()) * first + static_cast<std::size_t>(k) * rows, rows);
  }
}

template <class Real>
void FftYConvolution<Real>::load(const XSpectra<Real>& spectra, int k, Complex* line) const {
  if (alone()) return spectra.separate(k, line);
  for_each_piece(
      k, [&](int first, std::size_t piece, int rows) { std::copy_n(exchanged_.data() + piece, rows, line + first); });
}

template <class Real>
void FftYConvolution<Real>::store(int k, const Complex* line, XSpectra<Real>& spectra) {
  if (alone()) return spectra.combine(k, line);
  for_each_piece(
      k, [&](int first, std::size_t piece, int rows) { std::copy_n(line + first, rows, exchanged_.data() + piece); });
}

template <class Real>
template <class Work>
void FftYConvolution<Real>::for_each_bundle(Work work) const {
  for (int first = 0; first < wave_count(); first += bundle) work(first, std::min(bundle, wave_count() - first));
}

template <class Real>
void FftYConvolution<Real>::apply(XSpectra<Real>& spectra) {
  gather(spectra);
  for_each_bundle([&](int first, int count) {
    for (int n = 0; n < count; ++n) load(spectra, first + n, line(n));
    forward_.execute();
    for (int n = 0; n < count; ++n) multiply_by_kernel(first + n, wave(n));
    backward_.execute();
    for (int n = 0; n < count; ++n) store(first + n, wave(n), spectra);
  });
  scatter(spectra);
}

template class FftYConvolution<float>;
template class FftYConvolution<double>;

}  // namespace gearfilm
