#include "results/static_passage.hpp"

#include <algorithm>

#include "mesh/static_mesh.hpp"

namespace gearfilm {
namespace {

constexpr int positions = 200;  // of the mesh in a period

/// Forces of the contacts at rest [-] by their places, straight in between; at a jump both.
class StaticForces {
public:
  explicit StaticForces(const MeshModel& rest) {
    const StaticMesh cycle = quasi_static_cycle(rest, rest.scales.static_force, positions);
    for (const StaticPosition& at : cycle.positions) {
      for (std::size_t k = 0; k < at.contacts.size(); ++k) {
        points_.emplace_back(rest.path.position(at.contacts[k], at.T), at.forces[k]);
      }
    }
    std::ranges::stable_sort(points_, {}, &Point::first);
  }

  double at(double xi) const {
    const auto behind = std::ranges::upper_bound(points_, xi, {}, &Point::first);
    if (behind == points_.begin()) return points_.front().second;
    if (behind == points_.end()) return points_.back().second;
    const Point &a = *(behind - 1), &b = *behind;
    const double t = (xi - a.first) / (b.first - a.first);
    return (1.0 - t) * a.second + t * b.second;
  }

private:
  using Point = std::pair<double, double>;  ///< xi [m], force [-]
  std::vector<Point> points_;
};

}  // namespace

Passage static_passage(const Grid& grid, const MeshModel& rest, const Passage& passage) {
  const Scales& scales = rest.scales;
  RowStress row(grid, row_options(*rest.stress, grid.row_axis().central()));
  const StaticForces forces(rest);
  Passage found{FlankHistory(passage[pinion_body].path()), FlankHistory(passage[wheel_body].path())};
  const std::size_t size = grid.local_size();
  SurfaceLoads loads{std::vector<double>(size), {std::vector<double>(size), std::vector<double>(size)}};
  for (const SectionRecord& record : passage[pinion_body].records()) {
    const double force = forces.at(record.xi);
    std::ranges::fill(loads.pressure, 0.0);
    if (force > 0.0) {
      const ContactConditions conditions = rest.contact_at(0, record.xi).conditions;
      hertz_pressure(grid, scales, dry_contact(scales, conditions, force), loads.pressure);
    }
    const FilmSection section{&row, &row.evaluate(loads), {}};
    const auto records = section_records(scales, section, record.xi);
    for (std::size_t body = 0; body < body_count; ++body) found[body].add(records[body]);
  }
  return found;
}

}  // namespace gearfilm
