// Spectra of signals that are known.
#include "orbits/spectrum.hpp"

#include <cmath>
#include <numbers>

#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// mean + sum of a cos(2 pi f T + phase), with the steps of a march: not all equally long.
MotionSignal signal_of(const std::vector<SpectralLine>& lines, double mean, double T_end) {
  MotionSignal signal;
  for (double T = 0.0, n = 0.0; T < T_end + 0.05; T += 0.02 + 0.005 * std::sin(n++)) {
    StepRecord record;
    record.T = T;
    record.motion.H0() = mean;
    for (const SpectralLine& line : lines) {
      const double rate = 2.0 * std::numbers::pi * line.frequency, phase = rate * T + line.frequency;
      record.motion.H0() += line.amplitude * std::cos(phase);
      record.motion.V0() -= line.amplitude * rate * std::sin(phase);
    }
    signal.add(record);
  }
  return signal;
}

TEST(Spectrum, a_whole_number_of_periods_gives_its_lines) {
  const std::vector<SpectralLine> lines = {{0.5, 0.7}, {1.5, 0.02}};
  const MotionSignal signal = signal_of(lines, -1.5, 8.0);
  const std::vector<SpectralLine> spectrum = signal.spectrum(2.0, 6.0, SpectralWindow::none);
  EXPECT_NEAR(spectrum[0].amplitude, 1.5, 1e-6);
  const std::vector<SpectralLine> peaks = spectral_peaks(spectrum, SpectralWindow::none, 2);
  ASSERT_EQ(peaks.size(), 2u);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_NEAR(peaks[n].frequency, lines[n].frequency, 1e-12);
    EXPECT_NEAR(peaks[n].amplitude, lines[n].amplitude, 1e-5);
  }
}

// Harmonics of a periodic state fall off: none but the first is a maximum among its neighbours.
TEST(Spectrum, harmonics_are_lines_of_their_own) {
  const MotionSignal signal = signal_of({{0.5, 0.7}, {1.0, 0.4}, {1.5, 0.1}}, 0.0, 4.0);
  const std::vector<SpectralLine> peaks =
      spectral_peaks(signal.spectrum(0.0, 2.0, SpectralWindow::none), SpectralWindow::none, 3);
  ASSERT_EQ(peaks.size(), 3u);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_NEAR(peaks[n].frequency, 0.5 * (n + 1.0), 1e-12);
}

TEST(Spectrum, a_window_keeps_strange_lines_apart) {
  // No whole number of periods, a thousandfold difference: without a window the leakage would bury the small one.
  const MotionSignal signal = signal_of({{0.512, 0.7}, {1.9, 0.0007}}, -50.0, 40.0);
  const std::vector<SpectralLine> peaks =
      spectral_peaks(signal.spectrum(0.0, 40.0, SpectralWindow::hann), SpectralWindow::hann, 2);
  EXPECT_NEAR(peaks[0].frequency, 0.512, 0.5 / 40.0);
  EXPECT_NEAR(peaks[1].frequency, 1.9, 0.5 / 40.0);
  EXPECT_NEAR(peaks[1].amplitude, 0.0007, 0.2 * 0.0007);
}

TEST(Spectrum, deviation_is_about_the_mean) {
  const SignalDeviation deviation = signal_of({{1.0, 0.3}}, -1.5, 8.0).deviation(2.0, 6.0);
  EXPECT_NEAR(deviation.peak_to_peak, 0.6, 1e-3);
  EXPECT_NEAR(deviation.root_mean_square, 0.3 / std::sqrt(2.0), 1e-6);
}

TEST(Spectrum, the_later_of_two_motions_at_one_time_counts) {
  MotionSignal signal;
  for (int n = 0; n <= 100; ++n) {
    StepRecord record;
    record.T = 0.1 * n;
    record.motion.H0() = -77.0;
    signal.add(record);
    record.motion.H0() = 3.0;
    signal.add(record);
  }
  EXPECT_DOUBLE_EQ(signal.spectrum(1.0, 9.0, SpectralWindow::none)[0].amplitude, 3.0);
}

}  // namespace
}  // namespace gearfilm
