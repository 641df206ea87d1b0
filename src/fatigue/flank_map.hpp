// Fatigue of a flank over its length and depth, from the histories of its points.
#pragma once

#include <span>
#include <vector>

#include "fatigue/dang_van.hpp"
#include "fatigue/flank_history.hpp"

namespace gearfilm {

/// Stresses of the flank's points at the depths of this process, [point][depth], in Pa.
struct FlankMap {
  std::vector<double> dang_van;
  std::vector<double> von_mises;             ///< largest of the history
  std::vector<double> orthogonal_amplitude;  ///< half the range of tau_xz
};

FlankMap flank_map(const FlankHistory& history, std::span<const double> points, int depths,
                   const DangVanOptions& options);

/// Half the range of tau_xz alone.
std::vector<double> orthogonal_amplitudes(const FlankHistory& history, std::span<const double> points, int depths);

/// So many points at equal distances from the first one of a flank to the last [m].
std::vector<double> flank_points(const FlankPath& path, int count);

}  // namespace gearfilm
