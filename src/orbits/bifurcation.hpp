// What a branch of periodic motions passes through: tests that change their sign there, and where they do.
//
//   fold              t_lambda = 0: the branch turns round in the parameter, a multiplier is 1
//   flip              det(DP + I) = product of all 1 + mu_i = 0: a multiplier is -1, the period doubles
//   Neimark-Sacker    product of all 1 - mu_i mu_j, i < j, = 0 with a complex pair: |mu| = 1, a second frequency
//                     begins
//   grazing           the least approach of the flanks is zero: beyond it contact is lost
//   half              P_half(x) - x turns round, P_half the map over half the period: there a branch of doubled period
//                     meets the one it began on, and beyond it are the same motions again, half a period later
// Source: Yu. A. Kuznetsov, Elements of applied bifurcation theory (2004), ch. 10. doi 10.1007/978-1-4757-3978-7
#pragma once

#include <vector>

#include "orbits/branch_point.hpp"

namespace gearfilm {

enum class PointKind { regular, fold, flip, neimark_sacker, grazing };

/// "fold", "flip", "ns", "grazing"; "regular" for a point where nothing happens.
const char* name_of(PointKind kind);

struct Bifurcation {
  PointKind kind = PointKind::regular;
  double along = 0.0;  ///< distance from the point before, along its tangent
  BranchPoint point;
};

/// All that happens between a point and the next on its branch, in order; step: of the predictor between them.
/// Located to the tolerance, in the length of a step.
std::vector<Bifurcation> bifurcations_between(const BranchCorrector& corrector, const BranchPoint& before,
                                              const BranchPoint& after, double step, double tolerance);

/// Whether the motions of two points of even order lie on either side of one that repeats after half the period.
bool meets_half_order(const BranchPoint& before, const BranchPoint& after);

/// The eigenvector of the multiplier nearest -1, of length 1 in (q, v).
Motion flip_direction(const Monodromy& monodromy);

}  // namespace gearfilm
