// Codes of misses. A miss is the pressure of a node that was solved for at a time step less the one that was guessed
// [-]; its part, in [-1, 1], is the miss over the largest one of that step on all nodes. A part is kept as a whole
// number of 16 bits: 8191 times its fourth root, since where the film is thick and oil flows freely the smallest
// pressures count. On grids of many nodes, where that takes too much memory, it is 32767 times the part itself.
#pragma once

#include <cmath>
#include <cstdint>

namespace gearfilm {

class MissCode {
public:
  static constexpr double many_nodes = 25e3;

  explicit MissCode(double nodes_of_grid) : by_root_(nodes_of_grid < many_nodes) {}

  std::int16_t encoded(double part) const {
    const double size = by_root_ ? std::sqrt(std::sqrt(std::abs(part))) * largest_root : std::abs(part) * largest_part;
    return static_cast<std::int16_t>(std::copysign(size + 0.5, part));
  }
  double decoded(std::int16_t code) const {
    if (!by_root_) return code / largest_part;
    const double root = code / largest_root;
    return root * root * root * std::abs(root);
  }

private:
  static constexpr double largest_root = 8191.0, largest_part = 32767.0;
  bool by_root_;
};

}  // namespace gearfilm
