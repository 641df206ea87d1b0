#include "dynamics/binary_stream.hpp"

namespace gearfilm {

void append(std::vector<double>& values, const GridShape& shape) {
  const RowAxis& rows = shape.row_axis;
  values.insert(values.end(), {static_cast<double>(shape.nx), shape.x_min, shape.x_max, rows.mirrored() ? 1.0 : 0.0,
                               static_cast<double>(rows.count())});
  values.insert(values.end(), rows.y().begin(), rows.y().end());
}

void append(std::vector<double>& values, const Motion& motion) {
  values.push_back(static_cast<double>(motion.freedoms()));
  values.insert(values.end(), motion.q.begin(), motion.q.end());
  values.insert(values.end(), motion.v.begin(), motion.v.end());
}

std::span<const double> ValueReader::values(std::size_t count) {
  const std::span<const double> taken = rest_.first(count);
  rest_ = rest_.subspan(count);
  return taken;
}

GridShape ValueReader::shape() {
  const std::span<const double> v = values(5);
  const std::span<const double> y = values(static_cast<std::size_t>(v[4]));
  const Edge lower = v[3] != 0.0 ? Edge::symmetry : Edge::ambient;
  return {static_cast<int>(v[0]), v[1], v[2],
          y.empty() ? RowAxis() : RowAxis({y.begin(), y.end()}, lower, Edge::ambient)};
}

Motion ValueReader::motion() { return motion_from(values(2 * count())); }

}  // namespace gearfilm
