#include "results/sweep_point.hpp"

#include "orbits/described_dry_orbit.hpp"
#include "results/friction_summary.hpp"
#include "results/orbit_summary.hpp"

namespace gearfilm {
namespace {

/// Row by row.
Summary monodromy_json(const Monodromy& map) {
  Summary rows = Summary::array();
  for (const auto& row : map.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows;
}

Monodromy read_monodromy(const Summary& rows) {
  const auto size = static_cast<Eigen::Index>(rows.size());
  Monodromy map(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) map(i, j) = rows[i][j].get<double>();
  }
  return map;
}

/// The motion with which a point of a sweep ends: of a march, or of a periodic state. A pair alone has (H_0, V_0).
Motion motion_of(const Summary& point) {
  if (point.contains("states_after_leaving")) return point["states_after_leaving"][0].get<Motion>();
  if (point.contains("state_after_leaving")) return point["state_after_leaving"].get<Motion>();
  return {point["H0_after_leaving"].get<double>(), point["V0_after_leaving"].get<double>()};
}

}  // namespace

void add_orbit(const MeshModel& mesh, const DescribedOrbit& found, Summary& result) {
  result.update(orbit_summary(mesh, found));
  add_efficiency(mesh, result);
  result["monodromy"] = monodromy_json(found.orbit.monodromy);
}

void add_dry_orbit(const OrbitProblem& problem, const DryPointFound& found, Summary& result) {
  result["start"] = found.start;
  add_orbit(problem.mesh, describe(problem, found.orbit), result);
}

ChainLink read_link(const Summary& point) {
  ChainLink link{point["value"].get<double>(), {}, {}};
  link.guess.motion = motion_of(point);
  if (!point.contains("monodromy")) return link;  // of a march
  link.guess.monodromy = read_monodromy(point["monodromy"]);
  if (point.contains("dry_motion")) link.dry.emplace().start = point["dry_motion"].get<Motion>();
  return link;
}

}  // namespace gearfilm
