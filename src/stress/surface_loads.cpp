#include "stress/surface_loads.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

constexpr std::size_t load_count = 1 + body_count;

}  // namespace

SurfaceLoads surface_loads(const Grid& grid, FilmPressures pressures, std::span<const double> half_thickness,
                           std::span<const double> shear_stress) {
  const std::vector<double>& oil = pressures.of_oil;
  const std::size_t rows = grid.y_count(), size = oil.size();
  SurfaceLoads loads{{}, {std::vector<double>(size), std::vector<double>(size)}};
  for (std::size_t n = 0; n < size; ++n) {
    // p = 0 beyond both ends of a line.
    const double before = n >= rows ? oil[n - rows] : 0.0, behind = n + rows < size ? oil[n + rows] : 0.0;
    const double rolling = -half_thickness[n] * (behind - before) / (2.0 * grid.h_x());
    const double sliding = shear_stress.empty() ? 0.0 : shear_stress[n];
    loads.shear[pinion_body][n] = rolling - sliding;
    loads.shear[wheel_body][n] = rolling + sliding;
  }
  loads.pressure = std::move(pressures.total);
  return loads;
}

LoadSpectra::LoadSpectra(const Grid& grid, const SectionLines& lines)
    : own_rows_(grid.y_count()),
      lines_(lines),
      lattice_(lines.lattice()),
      rows_(load_count * own_rows_ * lattice_.length),
      spectra_(load_count * own_rows_ * lattice_.waves()),
      loads_(load_count * own_rows_ * 2 * lattice_.waves()),
      wave_(lattice_.waves()),
      line_(lattice_.length) {
  const int count = static_cast<int>(load_count) * own_rows_, length = lattice_.length;
  forward_ = fftw::Plan<double>(fftw_plan_many_dft_r2c(1, &length, count, rows_.data(), nullptr, 1, length,
                                                       reinterpret_cast<fftw_complex*>(spectra_.data()), nullptr, 1,
                                                       lattice_.waves(), fftw::effort));
  backward_ = fftw::Plan<double>(
      fftw_plan_dft_c2r_1d(length, reinterpret_cast<fftw_complex*>(wave_.data()), line_.data(), fftw::effort));
}

void LoadSpectra::transform(const SurfaceLoads& loads) {
  const std::array<const std::vector<double>*, load_count> fields{&loads.pressure, &loads.shear[pinion_body],
                                                                  &loads.shear[wheel_body]};
  double* row = rows_.data();
  for (const std::vector<double>* field : fields) {
    for (int j = 0; j < own_rows_; ++j, row += lattice_.length) {
      for (int i = 0; i < lines_.of_grid; ++i) row[lines_.before + i] = (*field)[i * own_rows_ + j];
    }
  }
  forward_.execute();
  const int waves = lattice_.waves();
  double* to = loads_.data();
  for (std::size_t n = 0; n < load_count * own_rows_; ++n, to += 2 * waves) {
    const std::complex<double>* from = spectra_.data() + n * waves;
    for (int k = 0; k < waves; ++k) {
      to[k] = from[k].real();
      to[waves + k] = from[k].imag();
    }
  }
}

void LoadSpectra::add_rows(const double* kernel, std::size_t load, bool imaginary, double* sum) const {
  const int n = lattice_.waves();
  double* sum_re = sum;
  double* sum_im = sum + n;
  for (int j = 0; j < own_rows_; ++j, kernel += n) {
    const double* re = loads_.data() + (load * own_rows_ + j) * 2 * n;
    const double* im = re + n;
    const double sign = imaginary ? -1.0 : 1.0;
    const double* to_re = imaginary ? im : re;
    const double* to_im = imaginary ? re : im;
    for (int k = 0; k < n; ++k) {
      sum_re[k] += sign * kernel[k] * to_re[k];
      sum_im[k] += kernel[k] * to_im[k];
    }
  }
}

void LoadSpectra::sum(const std::array<PlaceKernels, body_count>& kernels, bool symmetric,
                      std::span<double> sums) const {
  const std::size_t waves = lattice_.waves();
  const bool alike = kernels[0].pressure == kernels[1].pressure;
  std::ranges::fill(sums, 0.0);
  for (std::size_t c = 0; c < stress_components; ++c) {
    if (symmetric && is_across(c)) continue;
    const std::size_t kernel_at = c * own_rows_ * waves;
    const auto sum_of = [&](std::size_t body) { return sums.data() + (body * stress_components + c) * 2 * waves; };
    for (std::size_t body = 0; body < (alike ? 1 : body_count); ++body) {
      add_rows(kernels[body].pressure + kernel_at, 0, is_odd_in_x(SurfaceLoad::pressure, c), sum_of(body));
    }
    if (alike) std::copy_n(sum_of(pinion_body), 2 * waves, sum_of(wheel_body));
    for (std::size_t body = 0; body < body_count; ++body) {
      add_rows(kernels[body].shear + kernel_at, 1 + body, is_odd_in_x(SurfaceLoad::shear_x, c), sum_of(body));
    }
  }
}

void LoadSpectra::transform_back(std::span<const double> sums, bool symmetric,
                                 std::array<SectionStress, body_count>& sections, int place) {
  const int waves = lattice_.waves();
  for (std::size_t body = 0; body < body_count; ++body) {
    for (std::size_t c = 0; c < stress_components; ++c) {
      if (symmetric && is_across(c)) continue;
      const double* sum = sums.data() + (body * stress_components + c) * 2 * waves;
      for (int k = 0; k < waves; ++k) wave_.data()[k] = {sum[k], sum[waves + k]};
      backward_.execute();
      std::copy_n(line_.data(), lines_.count, sections[body].line_of(place, c).begin());
    }
  }
}

}  // namespace gearfilm
