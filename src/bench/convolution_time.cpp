#include "bench/convolution_time.hpp"

#include <cmath>

#include "bench/stopwatch.hpp"
#include "elasticity/fftw.hpp"

namespace gearfilm {
namespace {

double time_by_one_plan(int nx, int ny) {
  using Fftw = fftw::Interface<double>;
  const int length[2] = {fftw::fast_length(2 * nx - 1), fftw::fast_length(2 * ny - 1)};
  const std::size_t waves = static_cast<std::size_t>(length[0]) * (length[1] / 2 + 1);
  fftw::Buffer<double> padded(static_cast<std::size_t>(length[0]) * length[1]);
  fftw::Buffer<std::complex<double>> spectrum(waves);
  auto* raw = reinterpret_cast<Fftw::Complex*>(spectrum.data());
  const fftw::Plan<double> forward(
      Fftw::many_r2c(2, length, 1, padded.data(), nullptr, 1, 0, raw, nullptr, 1, 0, FFTW_MEASURE));
  const fftw::Plan<double> backward(
      Fftw::many_c2r(2, length, 1, raw, nullptr, 1, 0, padded.data(), nullptr, 1, 0, FFTW_MEASURE));
  const std::vector<double> kernel(waves, 1.0 / (static_cast<double>(length[0]) * length[1]));
  std::vector<double> field(static_cast<std::size_t>(nx) * ny, 1.0);
  return median_time([&] {
    std::fill_n(padded.data(), static_cast<std::size_t>(length[0]) * length[1], 0.0);
    for (int i = 0; i < nx; ++i) {
      std::copy_n(&field[static_cast<std::size_t>(i) * ny], ny,
                  padded.data() + static_cast<std::size_t>(i) * length[1]);
    }
    forward.execute();
    for (std::size_t n = 0; n < waves; ++n) spectrum.data()[n] *= kernel[n];
    backward.execute();
    for (int i = 0; i < nx; ++i) {
      std::copy_n(padded.data() + static_cast<std::size_t>(i) * length[1], ny,
                  &field[static_cast<std::size_t>(i) * ny]);
    }
  });
}

}  // namespace

// Which plan a measurement finds is a matter of chance, and plans differ by up to a third.
double convolution_time(int nx, int ny) {
  constexpr int plans = 3;
  double shortest = HUGE_VAL;
  for (int n = 0; n < plans; ++n) {
    fftw_forget_wisdom();
    shortest = std::min(shortest, time_by_one_plan(nx, ny));
  }
  return shortest;
}

}  // namespace gearfilm
