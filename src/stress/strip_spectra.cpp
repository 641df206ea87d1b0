#include "stress/strip_spectra.hpp"

namespace gearfilm {

StripSpectra::StripSpectra(const StripLattice& lattice)
    : lattice_(lattice), line_(lattice.length), wave_(lattice.waves()), corners_(lattice.reach + 2) {
  auto* waves = reinterpret_cast<fftw_complex*>(wave_.data());
  forward_ = fftw::Plan<double>(fftw_plan_dft_r2c_1d(lattice.length, line_.data(), waves, fftw::effort));
}

void StripSpectra::add(SurfaceLoad load, const Strip& strip, double z, double nu, std::span<double> spectra) {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const double x = (static_cast<double>(i) - 0.5) * lattice_.h_x;
    const Stress across =
        patch_corner(load, x, -strip.lower, z, nu) + -1.0 * patch_corner(load, x, -strip.upper, z, nu);
    corners_[i] = across.components();
  }
  for (std::size_t c = 0; c < stress_components; ++c) {
    const bool odd = is_odd_in_x(load, c);
    double* line = line_.data();
    std::fill_n(line, lattice_.length, 0.0);
    line[0] = odd ? 0.0 : corners_[1][c] - corners_[0][c];
    for (int i = 1; i <= lattice_.reach; ++i) {
      const double value = corners_[i + 1][c] - corners_[i][c];
      line[i] = value;
      line[lattice_.length - i] = odd ? -value : value;
    }
    forward_.execute();
    const int waves = lattice_.waves();
    for (int k = 0; k < waves; ++k) spectra[c * waves + k] += odd ? wave_.data()[k].imag() : wave_.data()[k].real();
  }
}

}  // namespace gearfilm
