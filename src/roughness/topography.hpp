// The heights of a flank that films follow node by node: waves along it or across it, and a measured profile.
//
//   z(s, y) = A cos(2 pi s/Lambda + phi)  or  A cos(2 pi y/Lambda)  ,  + profile(s)         [m], positive out of the
//   metal
// s [m]: length of the involute from its base circle, y from the middle of the face. The profile is a cubic B-spline of
// equidistant heights whose coefficients are those of the quasi-interpolation c_k = z_k - (z_{k-1} - 2 z_k +
// z_{k+1})/6, of fourth order, without oscillations at the ends; beyond its ends it is zero.
#pragma once

#include <optional>
#include <vector>

namespace gearfilm {

/// A height with its derivative by s or y.
struct SurfaceHeight {
  double value = 0.0;  ///< [m]
  double slope = 0.0;
};

struct Waviness {
  double amplitude = 0.0;   ///< A [m]
  double wavelength = 0.0;  ///< Lambda [m]
  double phase = 0.0;       ///< phi [rad]
};

/// Heights at equal distances.
struct HeightProfile {
  double begin = 0.0;  ///< s of the first one [m]
  double step = 0.0;   ///< [m]
  std::vector<double> heights;
};

class Topography {
public:
  Topography() = default;
  /// remaining: the part of the heights along the flank that a loaded contact is expected not to flatten.
  Topography(std::optional<Waviness> along, std::optional<Waviness> across, const HeightProfile& profile,
             double remaining);

  /// What travels with the flank, and what stands in the contact: waves whose crests lie along the rolling.
  SurfaceHeight along(double s) const;
  SurfaceHeight across(double y) const;
  bool travels() const { return along_ || !coefficients_.empty(); }
  bool varies_across() const { return across_.has_value(); }
  bool flat() const { return !travels() && !varies_across(); }
  double remaining() const { return remaining_; }

private:
  std::optional<Waviness> along_{}, across_{};
  double begin_ = 0.0, step_ = 0.0, remaining_ = 1.0;
  std::vector<double> coefficients_;  ///< of the B-spline, one beyond either end
};

}  // namespace gearfilm
