#include "results/sweep_point.hpp"

#include "orbits/described_dry_orbit.hpp"
#include "results/members.hpp"
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

struct Conditions {
  const CaseInput& here;
  const MeshModel& mesh;
};

constexpr auto condition_members = std::to_array<Member<Conditions>>({
    {"speed_rpm", "", "rpm", "speed of the pinion",
     [](const Conditions& at) -> Summary { return at.here.parameters.real("pinion.speed_rpm"); }, true},
    {"torque", "T_g1", "N m", "torque of the pinion",
     [](const Conditions& at) -> Summary { return at.here.pair.torque; }, true},
    {"m_ge", "m_ge", "kg", "equivalent mass of the pair",
     [](const Conditions& at) -> Summary { return *at.here.pair.equivalent_mass; }, true},
    {"I_n", "I_n", "-", "dimensionless inertia", [](const Conditions& at) -> Summary { return at.mesh.inertia; }, true},
    {"f_m", "f_m", "Hz", "mesh frequency", [](const Conditions& at) -> Summary { return at.mesh.mesh_frequency_si(); },
     true},
    {"f_n", "f_n", "Hz", "natural frequency of the dry pair",
     [](const Conditions& at) -> Summary { return at.mesh.frequency_si(); }, true},
});

}  // namespace

void add_conditions(const CaseInput& here, const MeshModel& mesh, Summary& result) {
  add_members(condition_members, Conditions{here, mesh}, result);
}

std::vector<TableColumn> condition_columns() { return sweep_columns(condition_members); }

std::string conditions_markdown() {
  return members_markdown("Conditions of a point of `sweep`", "Keys of each point.", condition_members);
}

void add_orbit(const MeshModel& mesh, const DescribedOrbit& found, Summary& result) {
  result.update(orbit_summary(mesh, found));
  result["monodromy"] = monodromy_json(found.orbit.monodromy);
}

void add_dry_orbit(const OrbitProblem& problem, const DryPointFound& found, Summary& result) {
  result["start"] = found.start;
  add_orbit(problem.mesh, describe(problem, found.orbit), result);
}

Summary marched_summary(const SettledMarch& march, const Scales& scales, bool lubricated) {
  const SettledFigures figures = figures_of(march, scales);
  Summary summary = {{"H0_after_leaving", march.end.motion.H0()}, {"V0_after_leaving", march.end.motion.V0()}};
  summary["poincare"] = Summary::array();
  for (const PoincarePoint& at : march.points) {
    Summary entry = {at.motion.H0(), at.motion.V0(), at.largest_force / scales.static_force,
                     at.smallest_force / scales.static_force};
    if (lubricated) entry.push_back(scales.thickness * at.smallest_film);
    summary["poincare"].push_back(std::move(entry));
  }
  summary["force_ratio_max"] = figures.largest_force;
  summary["total_force_ratio_min"] = figures.smallest_force;
  if (lubricated) summary["h_min"] = scales.thickness * figures.smallest_film;
  summary["contact_lost"] = figures.contact_lost;
  summary["repeats_every"] = known(figures.repeats_every);
  summary["repeats_within"] = figures.recurrence ? Summary(figures.recurrence->defect) : Summary();
  summary["settles_on"] = known(figures.settles_on);
  summary["settles_at"] = figures.settles_at;
  return summary;
}

ChainLink read_link(const Summary& point) {
  ChainLink link{point["value"].get<double>(), {}, {}};
  link.guess.motion = {point["H0_after_leaving"].get<double>(), point["V0_after_leaving"].get<double>()};
  if (!point.contains("monodromy")) return link;  // of a march
  link.guess.monodromy = read_monodromy(point["monodromy"]);
  if (point.contains("dry_motion")) link.dry.emplace().start = point["dry_motion"].get<Motion>();
  return link;
}

}  // namespace gearfilm
