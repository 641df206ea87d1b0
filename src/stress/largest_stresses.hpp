// What a section's stresses come to: their largest values over x at every depth, and over depths.
#pragma once

#include "stress/row_stress.hpp"
#include "stress/stress_depths.hpp"

namespace gearfilm {

/// Stresses of one body by depth, common to all processes, in p_h.
struct StressProfile {
  std::vector<double> von_mises;         ///< largest over x
  std::vector<double> largest_shear;     ///< largest over x
  std::vector<double> orthogonal_shear;  ///< half the range of tau_xz over x
  double surface_tension = 0.0;          ///< largest principal stress at z = 0; 0 where none is tensile
};

using StressProfiles = std::array<StressProfile, body_count>;

/// Largest stresses in the sections of both bodies. Collective.
StressProfiles stress_profiles(const RowStress& row, const SectionStresses& sections);

/// Largest values over depths, in p_h, and their depths in a.
struct LargestStresses {
  Peak von_mises, largest_shear, orthogonal_shear;
  double surface_tension = 0.0;
};

LargestStresses largest_stresses(const StressProfile& profile, std::span<const double> depths);

}  // namespace gearfilm
