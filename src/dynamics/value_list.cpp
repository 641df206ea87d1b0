#include "gearfilm/dynamics/value_list.hpp"

namespace gearfilm {

void append(std::vector<double>& values, const GridShape& shape) {
  values.insert(values.end(),
                {static_cast<double>(shape.nx), static_cast<double>(shape.ny), shape.x_min, shape.x_max, shape.y_half});
}

std::span<const double> ValueReader::values(std::size_t count) {
  const std::span<const double> taken = rest_.first(count);
  rest_ = rest_.subspan(count);
  return taken;
}

GridShape ValueReader::shape() {
  const std::span<const double> v = values(5);
  return {static_cast<int>(v[0]), static_cast<int>(v[1]), v[2], v[3], v[4]};
}

}  // namespace gearfilm
