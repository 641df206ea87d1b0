#include "orbits/stability_stretches.hpp"

namespace gearfilm {

void StabilityStretches::add(const Branch& branch, PointKind kind, const BranchPoint& point) {
  const double here = point.state.parameter;
  if (kind == PointKind::grazing) return;
  if (kind != PointKind::regular) {
    boundary_ = here;
    turned_ = turned_ || kind == PointKind::fold;
    return;
  }
  const bool stable = point.stable(), new_branch = stretches_.empty() || stretches_.back().branch != branch.number;
  if (new_branch) {
    stretches_.push_back({branch.number, branch.order, branch.born ? branch.born->parameter : here, here, stable});
  } else if (turned_ || stretches_.back().stable != stable) {
    const double border = boundary_.value_or(here);
    stretches_.back().to = border;
    stretches_.push_back({branch.number, branch.order, border, here, stable});
  } else {
    stretches_.back().to = here;
  }
  boundary_.reset();
  turned_ = false;
}

}  // namespace gearfilm
