// What fatigue of the flanks of a pair is judged by.
//
//   S_DV = (beta(z) - 2 alpha sigma_r(z)/3)/DV ,   beta = tau_w, or a factor times the hardness
// dang_van.hpp, material_profile.hpp. Where compression does not help, compressive residual stress counts as none.
#pragma once

#include <array>
#include <optional>

#include "fatigue/dang_van.hpp"
#include "fatigue/material_profile.hpp"
#include "fatigue/risk.hpp"

namespace gearfilm {

struct FatigueModel {
  DangVanOptions dang_van;
  RiskOptions risk;                         ///< its threshold in Pa
  int flank_points = 101;                   ///< on each flank
  double margin = 1.0;                      ///< at both ends of a flank, left out of largest values [a]
  double from_depth = 0.05;                 ///< of largest values below the surface [a]
  std::optional<double> torsion_limit{};    ///< tau_w [Pa]
  double shear_per_hardness = 0.4e6;        ///< [Pa/HV]
  std::array<FlankMaterial, 2> material{};  ///< pinion, wheel

  bool has_limit(std::size_t body) const { return torsion_limit || material[body].has_hardness(); }
  /// beta at a depth [Pa]; needs a limit.
  double limit(std::size_t body, double z) const {
    return torsion_limit ? *torsion_limit : shear_per_hardness * material[body].hardness(z);
  }
  /// S_DV at a depth [m] under dang_van [Pa].
  double safety(std::size_t body, double z, double dang_van_stress) const;
};

}  // namespace gearfilm
