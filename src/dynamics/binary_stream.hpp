// Lists of values, written and read one after the other: what a march remembers and its steps are stored as such lists.
#pragma once

#include <span>
#include <vector>

#include "grid/grid.hpp"
#include "mesh/motion.hpp"

namespace gearfilm {

void append(std::vector<double>& values, const GridShape& shape);
void append(std::vector<double>& values, const Motion& motion);

/// Takes values off the beginning of a list, in the order in which they were appended.
class ValueReader {
public:
  explicit ValueReader(std::span<const double> values) : rest_(values) {}

  bool at_end() const { return rest_.empty(); }
  double value() { return values(1).front(); }
  int whole() { return static_cast<int>(value()); }
  std::size_t count() { return static_cast<std::size_t>(value()); }
  std::span<const double> values(std::size_t count);
  GridShape shape();
  Motion motion();

private:
  std::span<const double> rest_;
};

}  // namespace gearfilm
