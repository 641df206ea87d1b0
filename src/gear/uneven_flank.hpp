// What flanks lack beside the middle of their faces, relative to what they lack in the middle at the same place along
// them.
//
//   D(rho, y) = E(rho, y) - E(rho, 0)        [m]; y from the middle of the face
// of curves E at some y: along them monotone cubics over the radius of curvature rho, between them linear in y,
// constant beyond. A contact at rho_1, rho_2 has the gap D_1 + D_2 there, or as in local_profile.hpp along x too.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "gear/local_profile.hpp"

namespace gearfilm {

class UnevenFlank {
public:
  /// Alike all over the face.
  UnevenFlank() = default;
  /// Curves at ascending y, an odd number with the middle of the face in their middle.
  UnevenFlank(std::vector<double> y, const std::vector<FlankCurve>& removed);

  bool even() const { return curves_.empty(); }
  /// Adds D at places y to values.
  void add(double rho, std::span<const double> y, std::span<double> values) const;

private:
  std::vector<double> y_;
  std::vector<MonotoneCubic> curves_;
};

/// What both flanks of a contact lack beside the middle of their faces.
struct UnevenProfile {
  std::shared_ptr<const std::array<UnevenFlank, 2>> flanks{};  ///< none: alike all over the face
  std::array<double, 2> rho{};                                 ///< at the contact's place [m]
  std::array<double, 2> base_radius{};                         ///< [m]
  bool along = false;                                          ///< flanks act on a film along it too

  /// D_1 + D_2 at x along the contact, at places y across it.
  std::vector<double> gap(double x, std::span<const double> y) const;
  bool operator==(const UnevenProfile&) const = default;
};

}  // namespace gearfilm
