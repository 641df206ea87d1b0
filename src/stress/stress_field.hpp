// Stresses in both bodies beneath all nodes of a film at one depth.
//
// By the same sums as those of one row (row_stress.hpp), from place to place along y. Kernels are made as they are
// needed and forgotten: for fields that are looked at now and then.
#pragma once

#include "stress/row_stress.hpp"

namespace gearfilm {

/// Stresses at a depth [a] beneath the nodes of the own rows, in p_h: [nx][own rows] of both bodies. Collective.
std::array<std::vector<Stress>, body_count> stress_field(const Grid& grid, const SurfaceLoads& loads, double depth,
                                                         const std::array<double, body_count>& poisson_ratio);

}  // namespace gearfilm
