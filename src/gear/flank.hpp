// What a flank lacks of the perfect involute: tip and root relief, slope and crowning of the profile, measured curves.
//
// Measured along the line of action, positive where material is removed, as a function of the flank's radius of
// curvature rho (the roll length):
//   tip relief   u = (rho - (rho_a - L))/L   root relief   u = (rho_s + L - rho)/L   E = C S(u) for u > 0
//   S = u (linear), u^2 (parabolic), u^2 (3 - 2 u) (smooth)
//   slope        f v                         crowning      C (2 v - 1)^2             v = (rho - rho_s)/(rho_a - rho_s)
// from the start rho_s of the active profile to its tip rho_a.
#pragma once

#include <vector>

#include "gear/monotone_cubic.hpp"

namespace gearfilm {

enum class ReliefShape { linear, parabolic, smooth };

struct Relief {
  double amount = 0.0;  ///< C [m]
  double length = 0.0;  ///< L, of roll [m]
  ReliefShape shape = ReliefShape::parabolic;
};

struct FlankModification {
  Relief tip;
  Relief root;
  double slope = 0.0;     ///< f [m]
  double crowning = 0.0;  ///< C of the profile [m]
  /// Measured or worn: rho and material removed [m], ascending in rho; their sum counts.
  std::vector<FlankCurve> curves{};
};

class Flank {
public:
  Flank() = default;
  /// start and tip: rho_s and rho_a [m].
  Flank(FlankModification modification, double start, double tip);

  /// E(rho) [m].
  double removed(double rho) const;
  bool perfect() const;

private:
  FlankModification modification_;
  double start_ = 0.0;
  double tip_ = 0.0;
  std::vector<MonotoneCubic> curves_;
};

}  // namespace gearfilm
