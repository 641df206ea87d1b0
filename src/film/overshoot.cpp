#include "film/overshoot.hpp"

#include <cmath>

namespace gearfilm {

bool has_overshot(const Overshoot& node) {
  constexpr double telling_growth = 0.1, telling_row = 0.5;  // the latter of what was expected
  return node.after < 0.0 && -node.after >= telling_row * node.expected && node.growth >= telling_growth;
}

// The left side falls with m: bisection.
double part_to_take(const Overshoot& node) {
  constexpr int halvings = 30;
  if (node.before < 0.0) return 0.5 * node.taken;
  const auto curved = [](double growth) { return std::expm1(growth) - growth; };
  const double beyond = node.after - node.expected * (1.0 - node.taken), whole = curved(node.growth);
  double low = 0.0, high = node.taken;
  for (int n = 0; n < halvings; ++n) {
    const double part = 0.5 * (low + high);
    const double row = node.expected * (1.0 - part) + beyond * curved(node.growth * part / node.taken) / whole;
    (row > 0.0 ? low : high) = part;
  }
  return low;
}

}  // namespace gearfilm
