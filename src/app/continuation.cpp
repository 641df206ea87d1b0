// `gearfilm continuation`: branches of periodic states in speed, torque, mass or viscosity, through folds and flips.
#include "app/branch_report.hpp"
#include "app/case_at.hpp"
#include "app/commands.hpp"
#include "app/derived.hpp"
#include "app/resumable_run.hpp"
#include "app/screen_table.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "orbits/pair_branch.hpp"
#include "output/results_table.hpp"

namespace gearfilm {
namespace {

std::vector<TableColumn> point_columns() {
  return {{"branch", "-", true},
          {"order", "-", true},
          {"kind", "-", true},
          {"speed_rpm", "rpm"},
          {"torque", "N m"},
          {"m_ge", "kg"},
          {"viscosity", "Pa s"},
          {"f_m", "Hz"},
          {"f_n", "Hz"},
          {"H0_after_leaving", "-"},
          {"V0_after_leaving", "-"},
          {"force_ratio_max", "-"},
          {"total_force_ratio_min", "-"},
          {"floquet_1_re", "-"},
          {"floquet_1_im", "-"},
          {"floquet_2_re", "-"},
          {"floquet_2_im", "-"},
          {"stable", "-", true}};
}

std::string kind_names() {
  std::string names;
  for (const PointKind kind :
       {PointKind::regular, PointKind::fold, PointKind::flip, PointKind::neimark_sacker, PointKind::grazing}) {
    names += std::to_string(static_cast<int>(kind)) + " " + name_of(kind) + "\n";
  }
  return names;
}

/// The table of points, written as they are found.
class PointTable {
public:
  PointTable(MPI_Comm comm, const Case& problem)
      : problem_(problem), file_(comm, problem.run.directory / "results.h5") {
    write_identity(file_, problem, "continuation");
    table_.emplace(file_, "/continuation", point_columns());
    file_.dataset_attribute("/continuation", "kinds", kind_names());
    file_.publish();
  }

  /// Returns what of it is in the summary.
  Summary add(const Branch& branch, PointKind kind, const BranchPoint& point) {
    const Case here = case_at(problem_, problem_.continuation.parameter, point.state.parameter);
    const MeshModel mesh = mesh_after_leaving(here);
    const auto mu = point.multipliers();
    const double speed = here.parameters.real("pinion.speed_rpm"), mass = *here.pair.equivalent_mass;
    const Lubricant& oil = here.scales.oil;
    table_->append({static_cast<double>(branch.number), static_cast<double>(branch.order), static_cast<double>(kind),
                    speed, here.pair.torque, mass, oil.viscosity, mesh.mesh_frequency_si(), mesh.frequency_si(),
                    point.state.motion.H0(), point.state.motion.V0(), point.value.largest_force,
                    point.value.smallest_force, mu[0].real(), mu[0].imag(), mu[1].real(), mu[1].imag(),
                    static_cast<double>(point.stable())});
    Summary summary = {
        {"speed_rpm", speed}, {"torque", here.pair.torque}, {"m_ge", mass}, {"viscosity", oil.viscosity}};
    summary["H0_after_leaving"] = point.state.motion.H0();
    summary["V0_after_leaving"] = point.state.motion.V0();
    summary["force_ratio_max"] = point.value.largest_force;
    summary["total_force_ratio_min"] = point.value.smallest_force;
    summary["floquet"] = mu;
    return summary;
  }

  void finish() {
    table_->write();
    table_.reset();
    file_.finish();
  }

private:
  const Case& problem_;
  ResultsFile file_;
  std::optional<ResultsTable> table_;
};

/// Steps of a branch may go beyond what there is of pairs.
ProblemAt problems_of(const Case& problem) {
  return [&problem](double value) {
    try {
      return orbit_problem(case_at(problem, problem.continuation.parameter, value));
    } catch (const InputError& error) {
      throw SolveError(error.what());
    }
  };
}

void check(const Case& problem) {
  require_inertia(problem);
  require_moving_contacts(problem, "continuation", true);
  if (!problem.dry() && !problem.search.with_multipliers) {
    problem.parameters.refuse("periodic.multipliers",
                              "is no, but continuation tells stability and bifurcations by them; set it "
                              "to yes");
  }
  require_one_pattern(problem, "continuation");
  const ContinuationCase& given = problem.continuation;
  if (!given.from) {
    throw InputError("the case '" + problem.name +
                     "' says nothing about its continuation; give continuation.from and continuation.to");
  }
  if (given.parameter == "lubricant.viscosity" && problem.dry()) {
    problem.parameters.refuse("model",
                              "is dry, but continuation in viscosity follows pairs on films; set it to dynamic");
  }
  if (given.parameter == "gear.equivalent_mass" && problem.pair.inertias) {
    throw InputError("a continuation in mass needs gear.equivalent_mass in the place of both inertias");
  }
  for (const double end : {*given.from, given.to}) (void)case_at(problem, given.parameter, end);
}

}  // namespace

void run_continuation(MPI_Comm comm, const Case& problem) {
  check(problem);
  const ContinuationCase& given = problem.continuation;
  const SharedDiscretisation films = discretise(comm, problem);
  ResumableRun run(problem, films->grid(), "continuation");
  const BranchEntry entry{*given.from, given.options.corrector.unit};
  const SearchWatch watch{.check_stop = run.stop().check_in(comm), .keeper = &run.checkpoint()};
  const BranchBeginning begin = problem.dry() ? dry_beginning(problems_of(problem), entry, run.stop().count_in(comm))
                                              : film_beginning(problems_of(problem), entry, comm, watch);
  PointTable table(comm, problem);
  BranchReport report(comm, given.unit, !problem.dry());
  int points = 0;
  const auto observer = [&](const Branch& branch, PointKind kind, const BranchPoint& point) {
    ++points;
    report.add(branch, kind, point, table.add(branch, kind, point));
  };
  std::vector<Branch> branches;
  const auto write = [&](bool completed) {
    table.finish();
    Summary summary = {{"case", problem.name}, {"over", given.parameter}, {"points", points}};
    if (begin.mesh_periods) summary["mesh_periods"] = *begin.mesh_periods;
    summary["branches"] = Summary::array();
    for (const Branch& branch : branches) summary["branches"].push_back(BranchReport::branch_summary(branch));
    summary.update(report.summary());
    summary["completed"] = completed;
    write_summary(comm, run.directory().path(), summary);
  };
  const auto again = [&](const Stopped& stopped) {
    return Stopped(std::string(stopped.what()) +
                   " (branches of the dry pair are then followed from the beginning: "
                   "give more time)");
  };
  try {
    branches = follow_branches(begin.map, problem.search.order, begin.start, given.upwards(), given.options, observer);
  } catch (const Stopped& stopped) {
    write(false);  // what was found until then
    throw problem.dry() ? again(stopped) : stopped;
  } catch (const Unfinished&) {
    write(false);
    throw;
  }
  write(true);
  run.complete();
  report.finish(branches);
  ScreenTable({}).print(comm, run.directory().path());
}

}  // namespace gearfilm
