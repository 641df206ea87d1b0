// Where a Newton step overshoots at single nodes: at the edge of the contact, where pressure is to fall.
//
// There the oil's conductance xi_R grows exponentially as pressure falls. Newton's method sees the small slope of the
// stiff oil at first, lets pressure fall to nothing, and finds a flow that is e^c times what it expected, c = ln of the
// growth of xi_R. A line search would shorten the steps of all nodes for the sake of a few. Instead such a node takes
// the part m of its change at which its own row vanishes,
//   d |v| (1 - m) + D (e^(c m) - 1 - c m)/(e^c - 1 - c) = 0 ,
// with v its whole change, d the slope of its row by its own pressure (reynolds.hpp), and D what its row has beyond the
// linear prediction after the part for which c holds: the neighbours' changes are taken as they are. A node that lacked
// oil before falls for the sake of its neighbours, which may not fall so far: it takes half of what it took.
#pragma once

namespace gearfilm {

/// What is known of a node after a part of its change was taken.
struct Overshoot {
  double expected;  ///< d |v| of its whole change
  double taken;     ///< the part that was taken
  double before;    ///< its row before the step
  double after;     ///< and after it
  double growth;    ///< c of the taken part
};

/// Oil comes in that nobody expected, by a conductance that has grown.
bool has_overshot(const Overshoot& node);

/// The part m of the change that a node which has overshot should take, less than was taken.
double part_to_take(const Overshoot& node);

}  // namespace gearfilm
