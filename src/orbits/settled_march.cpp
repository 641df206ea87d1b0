#include "orbits/settled_march.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dry_flow.hpp"
#include "dynamics/march_statistics.hpp"
#include "grid/remap.hpp"

namespace gearfilm {
namespace {

SettledMarch last_of(const std::vector<PoincarePoint>& all, const MarchLength& length, PairState end) {
  const auto kept = std::min(all.size(), static_cast<std::size_t>(length.kept));
  return {{all.end() - static_cast<std::ptrdiff_t>(kept), all.end()}, std::move(end)};
}

}  // namespace

PairState rescaled(const PairState& state, const Scales& from, const Scales& to) {
  PairState result = state;
  const double thickness = from.thickness / to.thickness;
  result.motion.q *= thickness;
  result.motion.v *= thickness * to.time / from.time;
  return result;
}

SettledMarch march_on_films(const OrbitProblem& problem, const SharedDiscretisation& films,
                            const std::optional<PairState>& from, const MarchLength& length, const SearchWatch& watch) {
  PoincareSection section;
  MeshMarch march = watched_march(
      problem, films, watch, [&](const StepRecord& record, const std::vector<ActiveContact>&) { section.add(record); });
  if (from && !from->films.empty() && same_lattice(from->shape, films->grid().shape())) {
    march.resume(0.0, *from);
  } else {
    march.start(from ? std::optional(from->motion) : std::nullopt);
  }
  march.run(length.mesh_periods * problem.mesh.path.mesh_period());
  return last_of(section.points(), length, march.state());
}

SettledMarch march_dry(const OrbitProblem& problem, const std::optional<Motion>& from, const MarchLength& length,
                       const StopCheck& check_stop) {
  const MeshModel& mesh = problem.mesh;
  std::vector<PoincarePoint> points;
  const auto on_period = [&](const DryPeriod& period) {
    const auto mesh_periods = static_cast<double>(points.size() + 1);
    points.push_back({mesh_periods * mesh.path.mesh_period(), period.motion, period.extremes.largest_force,
                      period.extremes.smallest_force, 0.0});
    check_stop(mesh_periods);
  };
  DryFlow::march(mesh, problem.search.dry_damping_ratio,
                 from ? mesh.in_train(*from) : DryMarch::balance(mesh, DryForce(mesh), 0.0), length.mesh_periods,
                 on_period);
  return last_of(points, length, {points.back().motion, {}});
}

SettledQuantities quantities_of(const SettledMarch& march, const Scales& scales) {
  SettledQuantities quantities{.smallest_force = HUGE_VAL, .smallest_film = HUGE_VAL};
  for (const PoincarePoint& point : march.points) {
    quantities.largest_force = std::max(quantities.largest_force, point.largest_force / scales.static_force);
    quantities.smallest_force = std::min(quantities.smallest_force, point.smallest_force / scales.static_force);
    quantities.smallest_film = std::min(quantities.smallest_film, point.smallest_film);
  }
  quantities.contact_lost = quantities.smallest_force < lost_force_ratio;
  quantities.recurrence = recurrence_of(march.points, same_point);
  quantities.settles_at = march.end.motion;
  if (!quantities.recurrence) return quantities;
  if (quantities.recurrence->period > 0) {
    quantities.repeats_every = quantities.settles_on = quantities.recurrence->period;
  } else if (const std::optional<Settling> settling = settling_of(march.points, *quantities.recurrence);
             settling && settling->contracts()) {
    quantities.settles_on = settling->period;
    quantities.settles_at = settling->limit;
  }
  return quantities;
}

}  // namespace gearfilm
