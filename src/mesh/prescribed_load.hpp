// The models of one contact whose share of the static force is prescribed, (5) and (6) of
// doi 10.1016/j.triboint.2013.01.017, in place of the contacts beside it.
//
//   simplified dynamic    I_n d2H_0/dT2 = F/f(xi) - F*
//   quasi-static          F = f(xi) F* : the same without inertia
#pragma once

#include "gear/load_sharing.hpp"

namespace gearfilm {

struct PrescribedLoad {
  LoadSharing sharing;
  /// Least number of time steps in a piece that stands for a jump of f.
  int jump_refinement = 10;
};

}  // namespace gearfilm
