#include "results/static_passage.hpp"

#include <algorithm>

#include "film/face_pressure.hpp"
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

/// What dry contacts of a pair do to the surfaces.
class DryLoads {
public:
  DryLoads(const Grid& grid, const Scales& scales)
      : grid_(grid),
        scales_(scales),
        along_face_(scales.solids.face ? discretise(grid, scales) : nullptr),
        loads_{std::vector<double>(grid.local_size()),
               {std::vector<double>(grid.local_size()), std::vector<double>(grid.local_size())}} {}

  const SurfaceLoads& under(double force, const ContactConditions& conditions) {
    constexpr double carrying = 0.01;  // of the static force: the least of the law of a face, without risk
    std::ranges::fill(loads_.pressure, 0.0);
    if (along_face_ && force > carrying * scales_.static_force) {
      face_pressure(*along_face_, scales_, conditions, force, loads_.pressure);
    } else if (!along_face_ && force > 0.0) {
      hertz_pressure(grid_, scales_, dry_contact(scales_, conditions, force), loads_.pressure);
    }
    return loads_;
  }

private:
  const Grid& grid_;
  const Scales& scales_;
  SharedDiscretisation along_face_;
  SurfaceLoads loads_;
};

}  // namespace

Passage static_passage(const Grid& grid, const MeshModel& rest, const Passage& passage) {
  const std::vector<int> rows = stress_rows(*rest.stress, grid.row_axis());
  RowStress below(grid, row_options(*rest.stress, rows));
  const StaticForces forces(rest);
  DryLoads loads(grid, rest.scales);
  FlankRecorder recorder(rest, true);
  for (const SectionRecord& record : passage.front()[pinion_body].records()) {
    const ContactConditions conditions = rest.contact_at(0, record.xi).conditions;
    const auto& sections = below.evaluate(loads.under(forces.at(record.xi), conditions));
    recorder.add(0, section_records(rest.scales, below, sections, record.xi));
  }
  return recorder.of_period(1).front();
}

}  // namespace gearfilm
