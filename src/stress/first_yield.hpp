// Where a dry contact first yields below its surface, while it is still elastic.
#pragma once

namespace gearfilm {

/// p_h over the yield stress at which the largest von Mises stress is that, beneath an ellipse whose shorter half-axis
/// over the longer one is given: 0 of a line contact to 1 of a circle. Bodies with Poisson's ratio 0.3; within 0.3 %.
double first_yield_ratio(double axes);

}  // namespace gearfilm
