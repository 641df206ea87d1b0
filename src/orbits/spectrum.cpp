#include "orbits/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "elasticity/fftw.hpp"

namespace gearfilm {

// States at an entering or a leaving repeat the time of the step before.
void Signal::sample(double T, double value, double rate) {
  if (!samples_.empty() && T <= samples_.back().T) samples_.pop_back();
  samples_.push_back({T, value, rate});
}

double Signal::value(double T) const {
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), T,
                                      [](const Sample& sample, double time) { return sample.T < time; });
  if (after == samples_.begin()) return after->value;
  if (after == samples_.end()) return samples_.back().value;
  const Sample &a = *(after - 1), &b = *after;
  const double step = b.T - a.T, s = (T - a.T) / step, r = 1.0 - s;
  return r * r * (1.0 + 2.0 * s) * a.value + s * s * (1.0 + 2.0 * r) * b.value +
         step * s * r * (r * a.rate - s * b.rate);
}

std::vector<double> Signal::uniform(double T_begin, double T_end) const {
  const auto steps = std::count_if(samples_.begin(), samples_.end(),
                                   [&](const Sample& sample) { return sample.T > T_begin && sample.T <= T_end; });
  std::vector<double> values(std::max<std::size_t>(2, static_cast<std::size_t>(steps) / 2 * 2));
  const double step = (T_end - T_begin) / static_cast<double>(values.size());
  for (std::size_t n = 0; n < values.size(); ++n) values[n] = value(T_begin + step * static_cast<double>(n));
  return values;
}

SignalDeviation Signal::deviation(double T_begin, double T_end) const {
  const std::vector<double> values = uniform(T_begin, T_end);
  const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (double v : values) squares += (v - mean) * (v - mean);
  return {*largest - *smallest, std::sqrt(squares / count)};
}

std::vector<SpectralLine> Signal::spectrum(double T_begin, double T_end, SpectralWindow window) const {
  const std::vector<double> values = uniform(T_begin, T_end);
  const int count = static_cast<int>(values.size());
  const auto weight = [&](int n) {
    return window == SpectralWindow::hann ? 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * n / count) : 1.0;
  };
  // A window would spread the mean over the neighbouring lines: the weighted mean goes first.
  double weights = 0.0, mean = 0.0;
  for (int n = 0; n < count; ++n) {
    weights += weight(n);
    mean += weight(n) * values[n];
  }
  mean /= weights;
  fftw::Buffer<double> signal(count);
  fftw::Buffer<std::complex<double>> transform(count / 2 + 1);
  const fftw::Plan<double> plan(
      fftw_plan_dft_r2c_1d(count, signal.data(), reinterpret_cast<fftw_complex*>(transform.data()), FFTW_ESTIMATE));
  for (int n = 0; n < count; ++n) signal.data()[n] = weight(n) * (values[n] - mean);
  plan.execute();
  std::vector<SpectralLine> lines = {{0.0, std::abs(mean)}};
  for (int n = 1; n < count / 2; ++n) {
    lines.push_back({n / (T_end - T_begin), 2.0 * std::abs(transform.data()[n]) / weights});
  }
  return lines;
}

std::vector<SpectralLine> spectral_peaks(const std::vector<SpectralLine>& lines, SpectralWindow window,
                                         std::size_t count) {
  std::vector<SpectralLine> peaks;
  for (std::size_t n = 1; n < lines.size(); ++n) {
    const double before = n > 1 ? lines[n - 1].amplitude : 0.0;
    const double after = n + 1 < lines.size() ? lines[n + 1].amplitude : 0.0;
    const bool highest = lines[n].amplitude > before && lines[n].amplitude > after;
    if (highest || window == SpectralWindow::none) peaks.push_back(lines[n]);
  }
  std::sort(peaks.begin(), peaks.end(),
            [](const SpectralLine& a, const SpectralLine& b) { return a.amplitude > b.amplitude; });
  if (peaks.size() > count) peaks.resize(count);
  return peaks;
}

}  // namespace gearfilm
