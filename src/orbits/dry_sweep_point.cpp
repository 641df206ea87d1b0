#include "orbits/dry_sweep_point.hpp"

#include "gearfilm/error.hpp"
#include "orbits/dry_following.hpp"
#include "orbits/settled_march.hpp"

namespace gearfilm {
std::optional<DryOrbit> follow_to_point(const ProblemAt& problem_at, double value, const BranchState& from,
                                        const DryWatch& watch) {
  const MeshAt mesh_at = [&](double at) { return problem_at(at).mesh; };
  const OrbitProblem here = problem_at(value);
  if (from.motion.freedoms() != here.mesh.freedoms()) return {};
  const double damping_ratio = here.search.dry_damping_ratio;
  const auto motion = follow_dry_branch(mesh_at, here.mesh.order, damping_ratio, from, value, watch);
  if (!motion) return {};
  std::optional<DryOrbit> orbit = follow_dry_orbit(here.mesh, damping_ratio, *motion);
  if (orbit && !is_same_motion(orbit->start, *motion)) orbit.reset();
  return orbit;
}

DryPointFound find_dry_point(const ProblemAt& problem_at, double value, const std::optional<BranchState>& neighbour,
                             const DryWatch& watch) {
  const OrbitProblem here = problem_at(value);
  const double damping_ratio = here.search.dry_damping_ratio;
  if (!neighbour) {
    const std::optional<Motion>& given = here.search.start;
    if (given) return {dry_orbit_from(here.mesh, damping_ratio, *given, watch), "given motion"};
    return {find_dry_orbit(here.mesh, damping_ratio, watch), "rest"};
  }
  if (const auto orbit = follow_to_point(problem_at, value, *neighbour, watch)) return {*orbit, "neighbour"};
  try {
    const Scales there = problem_at(neighbour->parameter).mesh.scales;
    const Motion from = rescaled({neighbour->motion, {}}, there, here.mesh.scales).motion;
    return {dry_orbit_after(here.mesh, damping_ratio, from, watch), "march from neighbour"};
  } catch (const SolveError&) {
    return {find_dry_orbit(here.mesh, damping_ratio, watch), "rest"};
  }
}

}  // namespace gearfilm
