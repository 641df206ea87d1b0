// Hardness and residual stress over the depth below a flank.
//
// Case hardened, of a surface hardness HV_s, a core's HV_c and the case depth CHD at 550 HV:
//   HV(z) = HV_c + (HV_s - HV_c) exp[ -ln((HV_s - HV_c)/(550 - HV_c)) (z/CHD)^2 ]
// This form is an assumption: it passes 550 HV at CHD by construction. Measured hardness is a table. Residual stress
// from hardness, in MPa (Lang; second-hand):
//   sigma_r = -1.25 (HV - HV_c)             HV - HV_c <= 300
//   sigma_r = 0.2857 (HV - HV_c) - 460      beyond
#pragma once

#include <optional>
#include <vector>

namespace gearfilm {

struct CaseHardening {
  double surface = 700.0;  ///< HV_s
  double core = 350.0;     ///< HV_c < 550 < HV_s
  double depth = 0.0;      ///< CHD [m]

  double hardness(double z) const;  ///< [HV]
};

/// A table by increasing depth [m], straight between its points; the first one must lie at 0.
struct DepthTable {
  std::vector<double> depth;
  std::vector<double> value;

  double deepest() const { return depth.back(); }
  double operator()(double z) const;
};

/// [Pa]
double residual_stress_of_hardness(double hardness, double core);

/// What strength of a flank is known of.
struct FlankMaterial {
  std::optional<CaseHardening> hardening{};
  std::optional<DepthTable> hardness_table{};
  bool residual_of_hardness = false;
  std::optional<DepthTable> residual_table{};  ///< [Pa]

  bool has_hardness() const { return hardening.has_value() || hardness_table.has_value(); }
  /// [HV]; needs a hardness.
  double hardness(double z) const;
  /// Residual stress in x and y [Pa].
  double residual_stress(double z) const;
  /// Down to where hardness and residual stress are known [m]; infinity for formulas.
  double known_to() const;
};

}  // namespace gearfilm
