// Amplitude spectrum of a signal over a span of a march, such as the rigid displacement H_0.
//
// The steps of a march are not equally long (they end at every entering and leaving): signals are sampled uniformly by
// cubic Hermite interpolation, since every step knows their rate too, and transformed with FFTW. Over a whole number of
// mesh periods of a periodic state the lines are the harmonics of the mesh frequency; any other span is weighted with a
// Hann window.
#pragma once

#include <vector>

#include "dynamics/step_record.hpp"

namespace gearfilm {

struct SpectralLine {
  double frequency = 0.0;  ///< [1/t*]
  double amplitude = 0.0;  ///< of the line at zero: that of the mean
};

/// How far a signal swings about its mean.
struct SignalDeviation {
  double peak_to_peak = 0.0;
  double root_mean_square = 0.0;
};

enum class SpectralWindow { none, hann };

class Signal {
public:
  /// rate: its derivative by T. Of two samples at one time the later counts.
  void sample(double T, double value, double rate);

  /// Lines from zero to the highest frequency that the steps resolve. The signal must cover [T_begin, T_end].
  std::vector<SpectralLine> spectrum(double T_begin, double T_end, SpectralWindow window) const;
  SignalDeviation deviation(double T_begin, double T_end) const;

private:
  struct Sample {
    double T = 0.0;
    double value = 0.0;
    double rate = 0.0;
  };

  double value(double T) const;
  /// As many uniform samples as there are steps, the end left out.
  std::vector<double> uniform(double T_begin, double T_end) const;

  std::vector<Sample> samples_;
};

/// H_0.
class MotionSignal : public Signal {
public:
  void add(const StepRecord& record) { sample(record.T, record.motion.H0(), record.motion.V0()); }
};

/// The largest lines beside zero frequency, largest first, at most `count`. A window spreads a line over its
/// neighbours: then only local maxima count.
std::vector<SpectralLine> spectral_peaks(const std::vector<SpectralLine>& lines, SpectralWindow window,
                                         std::size_t count);

}  // namespace gearfilm
