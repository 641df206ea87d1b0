// `gearfilm continuation`: branches of periodic states in speed, torque, mass or viscosity, through folds and flips.
#include "app/branch_report.hpp"
#include "app/commands.hpp"
#include "gearfilm/error.hpp"
#include "input/case_setup.hpp"
#include "input/case_with_parameter.hpp"
#include "orbits/pair_branch.hpp"
#include "output/resumable_run.hpp"
#include "output/screen_table.hpp"
#include "results/continuation_result.hpp"

namespace gearfilm {
namespace {

/// Steps of a branch may go beyond what there is of pairs.
ProblemAt problems_of(const CaseInput& problem) {
  return [&problem](double value) {
    try {
      return orbit_problem(case_with_parameter(problem, problem.continuation.parameter, value));
    } catch (const InputError& error) {
      throw SolveError(error.what());
    }
  };
}

void check_continuation(const CaseInput& problem) {
  require_inertia(problem);
  require_moving_train(problem, "continuation");
  require_moving_contacts(problem, "continuation", true);
  if (!problem.dry() && !problem.search.with_multipliers) {
    problem.parameters.refuse("periodic.multipliers",
                              "is no, but continuation needs them for stability and bifurcations; set it "
                              "to yes");
  }
  require_one_pattern(problem, "continuation");
  require_standing_heights(problem, "continuation");
  const ContinuationCase& given = problem.continuation;
  if (!given.from) {
    throw InputError("the case '" + problem.name +
                     "' has no range for its continuation; give continuation.from and continuation.to");
  }
  if (given.parameter == "lubricant.viscosity" && problem.dry()) {
    problem.parameters.refuse("model",
                              "is dry, but continuation in viscosity follows pairs on films; set it to dynamic");
  }
  if (given.parameter == "gear.equivalent_mass" && problem.pair.inertias) {
    throw InputError("a continuation in mass needs gear.equivalent_mass instead of both inertias");
  }
  for (const double end : {*given.from, given.to}) (void)case_with_parameter(problem, given.parameter, end);
}

Stopped stopped_dry(const Stopped& stopped) {
  return Stopped(stopped.what(), " (branches of the dry pair are then followed from the beginning: give more time)");
}

}  // namespace

void run_continuation(MPI_Comm comm, const CaseInput& problem) {
  check_continuation(problem);
  const ContinuationCase& given = problem.continuation;
  const SharedDiscretisation films = discretise(comm, problem);
  ResumableRun run(problem, films->grid(), "continuation");
  const BranchEntry entry{*given.from, given.options.corrector.unit};
  const SearchWatch watch{.check_stop = run.stop().check_in(comm), .store = &run.checkpoint()};
  const BranchBeginning begin = problem.dry()
                                    ? dry_beginning(problems_of(problem), entry, counted(run.stop().check_in(comm)))
                                    : film_beginning(problems_of(problem), entry, comm, watch);
  ContinuationResult result(comm, problem);
  BranchReport report(comm, given.unit, !problem.dry());
  const auto observer = [&](const Branch& branch, PointKind kind, const BranchPoint& point) {
    result.add(branch, kind, point);
    report.add(branch, kind, point);
  };
  std::vector<Branch> branches;
  const auto write = [&](bool completed) { result.write(branches, begin.mesh_periods.get(), completed); };
  try {
    branches = follow_branches(begin.map, problem.search.order, begin.start, given.upwards(), given.options, observer);
  } catch (const Stopped& stopped) {
    write(false);  // what was found until then
    if (problem.dry()) throw stopped_dry(stopped);
    throw;
  } catch (const Unfinished&) {
    write(false);
    throw;
  }
  write(true);
  run.complete();
  report.finish(branches, result.stretches().all());
  ScreenTable({}).print(comm, run.directory().path());
}

}  // namespace gearfilm
