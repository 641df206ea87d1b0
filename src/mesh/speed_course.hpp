// The speed of the pair over time, relative to the first: constant, or a ramp and constant after it.
//
//   r(T) = 1 + (q - 1) T/T_R for 0 < T < T_R, then q;   phase = Int_0^T r dT
// Phase is the time that would have passed at the first speed: it says where contacts are. Scales stay those of the
// first speed.
#pragma once

#include <algorithm>
#include <cmath>

namespace gearfilm {

struct SpeedCourse {
  double ratio = 1.0;     ///< q
  double duration = 0.0;  ///< T_R; 0: constant

  /// A ramp over so much phase.
  static SpeedCourse over_phase(double ratio, double phase) { return {ratio, 2.0 * phase / (1.0 + ratio)}; }

  double largest_speed() const { return std::max(1.0, ratio); }

  double speed(double T) const {
    if (duration == 0.0 || T <= 0.0) return 1.0;
    return T < duration ? 1.0 + (ratio - 1.0) * T / duration : ratio;
  }

  /// dr/dT.
  double acceleration(double T) const {
    return duration > 0.0 && T >= 0.0 && T <= duration ? (ratio - 1.0) / duration : 0.0;
  }

  double phase(double T) const {
    if (duration == 0.0 || T <= 0.0) return T;
    if (T < duration) return T + 0.5 * (ratio - 1.0) * T * T / duration;
    return 0.5 * (1.0 + ratio) * duration + ratio * (T - duration);
  }

  /// When so much phase has passed.
  double time(double phase) const {
    if (duration == 0.0 || phase <= 0.0) return phase;
    const double rest = phase - 0.5 * (1.0 + ratio) * duration;
    if (rest >= 0.0) return duration + rest / ratio;
    // The root of the parabola that stays finite as q goes to 1.
    return 2.0 * phase / (1.0 + std::sqrt(1.0 + 2.0 * (ratio - 1.0) * phase / duration));
  }
};

}  // namespace gearfilm
