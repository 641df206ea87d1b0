#include "gearfilm/periodic_state.hpp"

#include <algorithm>

#include "input/case_setup.hpp"
#include "input/case_with_parameter.hpp"
#include "interface/step_view.hpp"
#include "interface/views.hpp"
#include "orbits/orbit_starts.hpp"
#include "results/orbit_summary.hpp"

namespace gearfilm {
PeriodicState::PeriodicState(MPI_Comm comm, const Case& of, const Observer& observer) {
  const QuietErrors quiet;
  std::string remark;  // for nobody
  const CaseInput input = periodic_case(of.input(), remark);
  const OrbitProblem problem = orbit_problem(input);
  const Scales& scales = problem.mesh.scales;
  SearchWatch watch;
  if (observer) {
    watch.on_step = [&](const StepRecord& record, const std::vector<ActiveContact>& contacts) {
      observer(step_of(problem.mesh, record, contacts));
    };
  }
  const SharedDiscretisation films = input.dry() ? nullptr : discretise(comm, problem);
  const auto search = [&](const std::optional<StateBeside>& from) {
    OrbitProblem here = problem;
    if (from) here.search.start = from->motion;
    return find_orbit_with_errors(here, films, watch);
  };
  const auto beside = [&](const OrbitProblem& at_speed) { return find_orbit_beside(comm, at_speed, watch.check_stop); };
  const FoundOrbit found = find_orbit_from_starts(problem, problems_at_speeds(input), {search, beside});
  results_ = Results(Results::Content{periodic_summary(input, problem.mesh, found, errors_of(found))});
  if (found.own.decay) multipliers_.assign(found.own.decay->multipliers.begin(), found.own.decay->multipliers.end());
  begin_ = scales.time * found.own.orbit.begin;
  end_ = begin_ + scales.time * problem.mesh.period();
}

std::optional<bool> PeriodicState::stable() const {
  if (multipliers_.empty()) return {};
  return std::ranges::all_of(multipliers_, [](const std::complex<double>& value) { return std::abs(value) < 1.0; });
}

}  // namespace gearfilm
