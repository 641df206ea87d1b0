#include "orbits/orbit_starts.hpp"

#include <array>

#include "gearfilm/error.hpp"
#include "orbits/settled_march.hpp"

namespace gearfilm {
namespace {

constexpr std::array speeds_beside = {1.02, 0.98};  // over that of the pair

std::optional<StateBeside> state_beside(const OrbitProblem& problem, const ProblemAt& at_speed,
                                        const SearchesFromStarts& searches, const std::string& why) {
  for (const double ratio : speeds_beside) {
    try {
      OrbitProblem beside = at_speed(ratio);
      beside.search.with_multipliers = false;
      const PairState start{searches.beside(beside).orbit.start.motion, {}};
      return StateBeside{ratio, rescaled(start, beside.mesh.scales, problem.mesh.scales).motion, why};
    } catch (const SolveError&) {
      // The other speed may have one.
    } catch (const InputError&) {
      // That speed may not be given.
    }
  }
  return {};
}

}  // namespace

FoundOrbit find_orbit_from_starts(const OrbitProblem& problem, const ProblemAt& at_speed,
                                  const SearchesFromStarts& searches) {
  const bool has_others = !problem.search.start && !problem.mesh.train && problem.mesh.inertia > 0.0;
  if (!has_others) return searches.own({});
  std::optional<StateBeside> from;
  try {
    return searches.own({});
  } catch (const NoPeriodicState& error) {
    from = state_beside(problem, at_speed, searches, error.what());
    if (!from) throw;
  }
  return searches.own(from);
}

DescribedOrbit find_orbit_beside(MPI_Comm comm, const OrbitProblem& beside, const StopCheck& check_stop) {
  return find_orbit(beside, discretise(comm, beside), dry_start(beside.mesh), {.check_stop = check_stop}).own;
}

}  // namespace gearfilm
