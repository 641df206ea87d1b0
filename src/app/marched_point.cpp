#include "app/marched_point.hpp"

#include <algorithm>

#include "gearfilm/dynamics/dry_flow.hpp"
#include "gearfilm/dynamics/dry_pair.hpp"
#include "gearfilm/dynamics/march_statistics.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "gearfilm/orbits/dry_orbit.hpp"

namespace gearfilm {

PairState rescaled(const PairState& state, const Scales& from, const Scales& to) {
  PairState result = state;
  const double thickness = from.thickness / to.thickness;
  result.motion.H0() *= thickness;
  result.motion.V0() *= thickness * to.time / from.time;
  return result;
}

MarchedPoint march_point(const Case& problem, const MeshModel& mesh, const SharedDiscretisation& films,
                         const std::optional<PairState>& from, Checkpoint* checkpoint, const MarchWatch& watch) {
  const std::optional<Motion> motion = from ? std::optional(from->motion) : std::nullopt;
  const auto marched = [&](const std::vector<PoincarePoint>& all, PairState end) {
    const auto kept = std::min(all.size(), static_cast<std::size_t>(problem.sweep.kept_periods));
    return MarchedPoint{{all.end() - static_cast<std::ptrdiff_t>(kept), all.end()}, std::move(end)};
  };
  if (problem.dry()) {
    std::vector<PoincarePoint> points;
    const double damping_ratio = problem.march.dry_damping_ratio.value_or(typical_film_damping);
    DryFlow::march(
        mesh, damping_ratio, motion ? *motion : DryMarch::balance(mesh, DryForce(mesh), 0.0),
        problem.sweep.march_periods, [&](const DryPeriod& period) {
          const double T = static_cast<double>(points.size() + 1) * mesh.path.mesh_period();
          points.push_back({T, period.motion, period.extremes.largest_force, period.extremes.smallest_force, 0.0});
          watch(T, true);
        });
    return marched(points, {points.back().motion, {}});
  }
  PoincareSection section;
  const auto on_step = [&](const StepRecord& record, const std::vector<LiveContact>&) {
    section.add(record);
    watch(record.T, checkpoint->is_new(record));
  };
  MeshMarch march = make_march(problem, films, mesh, on_step, checkpoint);
  if (from && !from->films.empty()) {
    march.resume(0.0, *from);
  } else {
    march.start(motion);
  }
  march.run(problem.sweep.march_periods * mesh.path.mesh_period());
  return marched(section.points(), march.state());
}

Summary marched_summary(const Case& problem, const MarchedPoint& point) {
  constexpr double tolerance = 1e-3;  // in (H_0, V_0)
  const Scales& scales = problem.scales;
  double largest = 0.0, smallest = HUGE_VAL, film = HUGE_VAL;
  Summary summary = {{"H0_after_leaving", point.end.motion.H0()}, {"V0_after_leaving", point.end.motion.V0()}};
  summary["poincare"] = Summary::array();
  for (const PoincarePoint& at : point.points) {
    const double force_max = at.largest_force / scales.static_force,
                 force_min = at.smallest_force / scales.static_force;
    largest = std::max(largest, force_max);
    smallest = std::min(smallest, force_min);
    film = std::min(film, scales.thickness * at.smallest_film);
    Summary entry = {at.motion.H0(), at.motion.V0(), force_max, force_min};
    if (!problem.dry()) entry.push_back(scales.thickness * at.smallest_film);
    summary["poincare"].push_back(std::move(entry));
  }
  summary["force_ratio_max"] = largest;
  summary["total_force_ratio_min"] = smallest;
  if (!problem.dry()) summary["h_min"] = film;
  summary["contact_lost"] = smallest < lost_force_ratio;
  const std::optional<Recurrence> recurrence = recurrence_of(point.points, tolerance);
  const bool repeats = recurrence && recurrence->period > 0;
  summary["repeats_every"] = repeats ? Summary(recurrence->period) : Summary();
  summary["repeats_within"] = recurrence ? Summary(recurrence->defect) : Summary();
  const std::optional<Settling> settling = recurrence ? settling_of(point.points, *recurrence) : std::nullopt;
  const bool settles = !repeats && settling && settling->contracts();
  summary["settles_on"] = settles ? Summary(settling->period) : summary["repeats_every"];
  summary["settles_at"] = settles ? settling->limit : point.end.motion;
  return summary;
}

}  // namespace gearfilm
