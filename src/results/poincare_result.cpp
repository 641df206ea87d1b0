#include "results/poincare_result.hpp"

#include <cmath>

#include "results/members.hpp"

namespace gearfilm {
namespace {

/// A point of the march of a pair.
struct PointOfPair {
  const MeshModel& mesh;
  const PoincarePoint& point;
};

constexpr auto history_members = std::to_array<Member<PointOfPair>>({
    {"T", "T", "-", "time in units of a/u_m* just after a contact has left",
     [](const PointOfPair& at) -> Summary { return at.point.T; }, Column::real},
    {"t", "t", "s", "the same", [](const PointOfPair& at) -> Summary { return at.mesh.scales.time * at.point.T; },
     Column::real},
    {"distance", "", "m", "way along the line of action since the start",
     [](const PointOfPair& at) -> Summary { return at.mesh.path.distance(at.point.T); }, Column::real},
    {"pinion_speed", "", "rpm", "rotational speed of the pinion",
     [](const PointOfPair& at) -> Summary { return at.mesh.path.rpm(at.point.T); }, Column::real},
    {"H0", "H_0", "-", "rigid displacement there",
     [](const PointOfPair& at) -> Summary { return at.point.motion.H0(); }, Column::real},
    {"V0", "V_0", "-", "its velocity there", [](const PointOfPair& at) -> Summary { return at.point.motion.V0(); },
     Column::real},
    {"force_max", "", "N", "largest force on one contact since the point before",
     [](const PointOfPair& at) -> Summary { return at.mesh.scales.force(at.point.largest_force); }, Column::real},
    {"force_total_min", "", "N", "smallest force on all contacts together since then",
     [](const PointOfPair& at) -> Summary { return at.mesh.scales.force(at.point.smallest_force); }, Column::real},
    {"h_min", "", "m", "smallest film since then; not in the dry model",
     [](const PointOfPair& at) -> Summary { return at.mesh.scales.thickness * at.point.smallest_film; }, Column::film},
});

/// A point of a march of a sweep.
struct PointOfMarch {
  const Scales& scales;
  const PoincarePoint& point;
};

constexpr auto diagram_members = std::to_array<Member<PointOfMarch>>({
    {"H0", "H_0", "-", "rigid displacement just after a contact has left",
     [](const PointOfMarch& at) -> Summary { return at.point.motion.H0(); }, Column::real},
    {"V0", "V_0", "-", "its velocity there", [](const PointOfMarch& at) -> Summary { return at.point.motion.V0(); },
     Column::real},
    {"force_ratio_max", "", "-", "largest force on one contact over the static force, since the point before",
     [](const PointOfMarch& at) -> Summary { return at.point.largest_force / at.scales.static_force; }, Column::real},
    {"total_force_ratio_min", "", "-", "smallest force on all contacts together over it, since then",
     [](const PointOfMarch& at) -> Summary { return at.point.smallest_force / at.scales.static_force; }, Column::real},
    {"h_min", "", "m", "smallest film since then; not in the dry model",
     [](const PointOfMarch& at) -> Summary { return at.scales.thickness * at.point.smallest_film; }, Column::film},
});

/// A whole march of a sweep.
struct MarchOfSweep {
  const SettledMarch& march;
  const Scales& scales;
  SettledQuantities quantities;
  bool lubricated = true;
};

constexpr auto marched_members = std::to_array<Member<MarchOfSweep>>({
    {"H0_after_leaving", "H_0", "-", "H_0 at its end, just after a contact has left",
     [](const MarchOfSweep& of) -> Summary { return of.march.end.motion.H0(); }, Column::real},
    {"V0_after_leaving", "V_0", "-", "V_0 there",
     [](const MarchOfSweep& of) -> Summary { return of.march.end.motion.V0(); }, Column::real},
    {"state_after_leaving", "", "-", "of a drive train: all displacements there, then all velocities",
     [](const MarchOfSweep& of) -> Summary {
       const Motion& motion = of.march.end.motion;
       return motion.freedoms() > 1 ? Summary(motion) : absent();
     }},
    {"force_ratio_max", "", "-", "largest force on one contact over the static force, in the mesh periods kept",
     [](const MarchOfSweep& of) -> Summary { return of.quantities.largest_force; }, Column::real},
    {"total_force_ratio_min", "", "-", "smallest force on all contacts together over it",
     [](const MarchOfSweep& of) -> Summary { return of.quantities.smallest_force; }, Column::real},
    {"contact_lost", "", "", "whether the total force falls below 0.02 of the static force",
     [](const MarchOfSweep& of) -> Summary { return of.quantities.contact_lost; }, Column::real},
    {"settles_on", "", "-", "mesh periods after which the motion that it comes to repeat begins again; null: none",
     [](const MarchOfSweep& of) -> Summary { return known(of.quantities.settles_on); }, Column::real},
    {"settles_at", "", "-", "(H0, V0) of that motion once in it",
     [](const MarchOfSweep& of) -> Summary { return of.quantities.settles_at; }},
    {"repeats_every", "", "-", "mesh periods after which the march repeats; null where it does not yet",
     [](const MarchOfSweep& of) -> Summary { return known(of.quantities.repeats_every); }},
    {"repeats_within", "", "-", "distance in (H0, V0) within which it does",
     [](const MarchOfSweep& of) -> Summary {
       return of.quantities.recurrence ? Summary(of.quantities.recurrence->defect) : Summary();
     }},
    {"poincare", "", "", "its points: the columns of `/diagram` from H0 on",
     [](const MarchOfSweep& of) -> Summary {
       Summary points = Summary::array();
       for (const PoincarePoint& point : of.march.points) {
         std::vector<double> row;
         add_to_row(diagram_members, PointOfMarch{of.scales, point}, row, of.lubricated);
         points.push_back(row);
       }
       return points;
     }},
    {"h_min", "", "m", "smallest film; not in the dry model",
     [](const MarchOfSweep& of) -> Summary {
       return of.lubricated ? Summary(of.scales.thickness * of.quantities.smallest_film) : absent();
     },
     Column::film},
});

/// Whether a march repeats, and how it settles.
struct RecurrenceOfMarch {
  Recurrence recurrence;
  std::optional<Settling> settling;
};

constexpr auto settling_members = std::to_array<Member<Settling>>({
    {"mesh_periods", "", "-", "over which a disturbance is multiplied",
     [](const Settling& of) -> Summary { return of.period; }},
    {"multiplier", "", "-", "by what: real and imaginary part",
     [](const Settling& of) -> Summary { return of.multiplier; }},
    {"modulus", "", "-", "its modulus", [](const Settling& of) -> Summary { return std::abs(of.multiplier); }},
    {"modulus_error", "", "-", "error of the modulus, twice its standard deviation",
     [](const Settling& of) -> Summary { return of.modulus_error; }},
});

constexpr auto recurrence_members = std::to_array<Member<RecurrenceOfMarch>>({
    {"repeats_every", "", "-", "mesh periods after which the march repeats; null where it does not yet",
     [](const RecurrenceOfMarch& of) -> Summary {
       return of.recurrence.period > 0 ? Summary(of.recurrence.period) : Summary();
     }},
    {"repeats_within", "", "-", "distance in (H0, V0) within which it does",
     [](const RecurrenceOfMarch& of) -> Summary { return of.recurrence.defect; }},
    {"settles_on", "", "-", "mesh periods of the motion that it comes to repeat; null where it is not certain of one",
     [](const RecurrenceOfMarch& of) -> Summary {
       if (!of.settling) return absent();
       return of.settling->contracts() ? Summary(of.settling->period) : Summary();
     }},
    {"settling", "", "", "how disturbances die away on the way there, as below",
     [](const RecurrenceOfMarch& of) -> Summary {
       return of.settling ? as_summary(settling_members, *of.settling) : absent();
     }},
});

}  // namespace

void write_poincare(ResultsFile& file, const MeshModel& mesh, bool lubricated,
                    const std::vector<PoincarePoint>& points) {
  std::vector<double> rows;
  for (const PoincarePoint& point : points) add_to_row(history_members, PointOfPair{mesh, point}, rows, lubricated);
  write_table(file, "/history/poincare", columns_of(history_members, lubricated), rows);
}

void add_recurrence(const std::vector<PoincarePoint>& points, Summary& summary) {
  const auto recurrence = recurrence_of(points, same_point);
  if (!recurrence) return;
  add_members(recurrence_members, RecurrenceOfMarch{*recurrence, settling_of(points, *recurrence)}, summary);
}

Summary marched_summary(const SettledMarch& march, const Scales& scales, bool lubricated) {
  return as_summary(marched_members, MarchOfSweep{march, scales, quantities_of(march, scales), lubricated});
}

std::vector<TableColumn> marched_columns(bool lubricated) { return columns_of(marched_members, lubricated); }

std::vector<TableColumn> diagram_columns(bool lubricated) { return columns_of(diagram_members, lubricated); }

std::string poincare_markdown() {
  return members_markdown("`/history/poincare`", "One row a mesh period of `transient`.", history_members) +
         members_markdown("How a march repeats", "Keys of the summary of `transient`.", recurrence_members) +
         members_markdown("How it settles", "Keys of `settling` there.", settling_members) +
         members_markdown("A march of a sweep", "Keys of each point of `sweep` with `sweep.kind` marches or basins.",
                          marched_members, "`/sweep`") +
         members_markdown("`/diagram`", "One row a mesh period that is kept of such a march, after its conditions.",
                          diagram_members);
}

}  // namespace gearfilm
