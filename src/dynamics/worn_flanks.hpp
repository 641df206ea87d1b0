// Flanks that wear over many revolutions of the pinion, in steps: what a mesh period rubs off at the present profiles
// is taken to stay the same until a flank has lost a given depth, then profiles and roughness are those of the step's
// end.
//
//   depth_i(s, y) = N_i V_i(s, y)/area ,  N_1 = N ,  N_2 = N Z_1/Z_2          V_i of flank_wear.hpp, N revolutions
//   sigma = sigma_inf + (sigma_0 - sigma_inf) exp(-W/W_r)                     running-in, where it is asked for
// W [J/m^2]: work of the asperities, by N mesh periods, over the area of a pinion's active flank. Assumptions: heights
// stay Gaussian; films that do not reach the ends of the face have the profile of its middle all over them.
#pragma once

#include <array>
#include <optional>

#include "dynamics/flank_wear.hpp"
#include "gear/monotone_cubic.hpp"

namespace gearfilm {

struct RunningIn {
  double final_roughness = 0.0;  ///< sigma_inf [m]
  double work = 0.0;             ///< W_r [J/m^2]
};

/// What a mesh period takes from a flank, and its asperities' work [J].
struct PeriodWear {
  std::array<FlankVolumes, 2> volumes;
  double work = 0.0;
};

class WornPair {
public:
  /// speed_ratio: Z_1/Z_2; roughness: sigma_0 [m].
  WornPair(const std::array<FlankPlaces, 2>& places, double speed_ratio, double roughness,
           const std::optional<RunningIn>& running_in);

  /// Revolutions in which no flank loses more than a depth [m], and the roughness changes by no more than a tenth;
  /// infinite where nothing changes.
  double revolutions_to(const PeriodWear& period, double depth) const;
  void wear(const PeriodWear& period, double revolutions);

  double revolutions() const { return revolutions_; }
  double roughness() const;
  double depth(std::size_t gear, int k, int j) const;  ///< at a place [m]
  double largest_depth(std::size_t gear) const;
  double volume(std::size_t gear) const;  ///< of one tooth [m^3]
  /// The depth over the radius of curvature at a place across the face.
  FlankCurve profile(std::size_t gear, double base_radius, int j) const;
  const FlankPlaces& places(std::size_t gear) const { return places_[gear]; }

private:
  double passages(std::size_t gear, double revolutions) const {
    return gear == 0 ? revolutions : speed_ratio_ * revolutions;
  }
  double largest_depth(std::size_t gear, const FlankVolumes& volumes) const;

  std::array<FlankPlaces, 2> places_;
  double speed_ratio_, first_roughness_;
  std::optional<RunningIn> running_in_;
  double flank_area_;  ///< of the pinion [m^2]
  std::array<FlankVolumes, 2> volumes_;
  double revolutions_ = 0.0, work_ = 0.0;  ///< so far; [J/m^2]
};

}  // namespace gearfilm
