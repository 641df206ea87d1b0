#include "app/dry_point.hpp"

#include "app/case_at.hpp"
#include "app/marched_point.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "gearfilm/orbits/dry_following.hpp"

namespace gearfilm {
namespace {

constexpr double same_motion = 1e-3;  // in (H_0, V_0), of what was followed and what Newton's method makes of it

}  // namespace

std::optional<DryOrbit> follow_to_point(const Case& problem, double value, const BranchState& from,
                                        const DryWatch& watch) {
  const MeshAt mesh_at = [&](double at) { return mesh_after_leaving(case_at(problem, problem.sweep.parameter, at)); };
  const double damping_ratio = dry_damping_ratio(problem);
  const auto motion = follow_dry_branch(mesh_at, problem.search.order, damping_ratio, from, value, watch);
  if (!motion) return {};
  std::optional<DryOrbit> orbit = follow_dry_orbit(mesh_at(value), damping_ratio, *motion);
  if (orbit && length(difference(orbit->start, *motion)) > same_motion) orbit.reset();
  return orbit;
}

DryPointFound find_dry_point(const Case& problem, double value, const std::optional<BranchState>& neighbour,
                             const DryWatch& watch) {
  const Case here = case_at(problem, problem.sweep.parameter, value);
  const MeshModel mesh = mesh_after_leaving(here);
  const double damping_ratio = dry_damping_ratio(here);
  if (!neighbour) {
    const std::optional<Motion>& given = here.march.start_motion;
    if (given) return {dry_orbit_from(mesh, damping_ratio, *given, watch), "given motion"};
    return {find_dry_orbit(mesh, damping_ratio, watch), "rest"};
  }
  if (const auto orbit = follow_to_point(problem, value, *neighbour, watch)) return {*orbit, "neighbour"};
  const Case there = case_at(problem, problem.sweep.parameter, neighbour->parameter);
  try {
    const Motion from = rescaled({neighbour->motion, {}}, there.scales, here.scales).motion;
    return {dry_orbit_after(mesh, damping_ratio, from, watch), "march from neighbour"};
  } catch (const SolveError&) {
    return {find_dry_orbit(mesh, damping_ratio, watch), "rest"};
  }
}

}  // namespace gearfilm
