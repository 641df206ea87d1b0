// `gearfilm sweep`: periodic states over a range of speeds, torques or masses, each from its neighbour's.
#include <algorithm>
#include <iomanip>
#include <limits>

#include "app/commands.hpp"
#include "app/corner_contact.hpp"
#include "app/result_warnings.hpp"
#include "app/sweep_chain.hpp"
#include "app/sweep_mending.hpp"
#include "dynamics/period_quantities.hpp"
#include "gearfilm/error.hpp"
#include "input/case_setup.hpp"
#include "input/case_with_parameter.hpp"
#include "output/output_directory.hpp"
#include "output/results_table.hpp"
#include "output/screen.hpp"
#include "output/screen_table.hpp"
#include "parallel/agreement.hpp"
#include "results/derived.hpp"
#include "results/friction_summary.hpp"
#include "results/sweep_tables.hpp"

namespace gearfilm {
namespace {

std::vector<SweepPoint> points_of(const SweepOptions& sweep) {
  std::vector<SweepPoint> points;
  const std::size_t count = sweep.values.size();
  for (std::size_t n = 0; sweep.up && n < count; ++n) points.push_back({SweepDirection::up, n});
  for (std::size_t n = count; sweep.down && n > 0; --n) points.push_back({SweepDirection::down, n - 1});
  return points;
}

// The cut does not depend on the number of processes, so that the results do not either.
std::vector<SweepChain> chains_of(const SweepOptions& sweep) {
  const std::size_t longest = sweep.chain_points > 0 ? sweep.chain_points : sweep.values.size();
  std::vector<SweepChain> chains;
  for (const SweepPoint& point : points_of(sweep)) {
    const bool turns = chains.empty() || chains.back().back().direction != point.direction;
    if (turns || chains.back().size() == longest) chains.emplace_back();
    chains.back().push_back(point);
  }
  return chains;
}

/// Groups of processes, as equal as can be, to which chains are dealt out.
int group_count(MPI_Comm comm, const CaseInput& problem) {
  const int size = processes_in(comm);
  const int chains = static_cast<int>(chains_of(problem.sweep).size());
  const int groups = std::min({problem.sweep.groups > 0 ? problem.sweep.groups : chains, chains, size});
  const int largest = (size + groups - 1) / groups;
  const int rows = case_grid(problem).rows();
  if (largest > rows) {
    throw InputError("a group of the sweep would have ", largest, " processes for a grid of ny = ", problem.numerics.ny,
                     " (", rows,
                     " rows with Y >= 0); use fewer processes, or shorter chains (sweep_chain_points) for more groups");
  }
  return groups;
}

void run_chains(MPI_Comm comm, const CaseInput& problem, const SweepPoints& points, int groups,
                const StopRequest& stop) {
  const std::vector<SweepChain> chains = chains_of(problem.sweep);
  const int size = processes_in(comm), rank = rank_in(comm);
  const int own = static_cast<int>(static_cast<long>(rank) * groups / size);
  MPI_Comm group = MPI_COMM_NULL;
  MPI_Comm_split(comm, own, rank, &group);
  std::string stopped;
  try {
    for (std::size_t n = own; n < chains.size(); n += groups) run_chain(group, problem, points, chains[n], stop);
  } catch (const Stopped& reason) {
    stopped = reason.what();
  }
  MPI_Comm_free(&group);
  wait_asleep(comm);
  stopped = first_reason(comm, stopped);
  if (!stopped.empty()) throw Stopped(stopped);
}

/// The extremes over all points, and where they are.
void print_extremes(MPI_Comm comm, const CaseInput& problem, const Summary& summary) {
  ScreenTable table(summary);
  const auto add = [&](const std::string& label, const char* key, double sign, double factor, const char* unit) {
    const Summary* worst = nullptr;
    for (const Summary& point : summary["points"]) {
      if (!point.contains(key) || !point[key].is_number()) continue;
      if (!worst || sign * point[key].get<double>() > sign * (*worst)[key].get<double>()) worst = &point;
    }
    if (!worst) return;
    table.text(label, worded(std::setprecision(5), factor * (*worst)[key].get<double>(), unit, " at ",
                             (*worst)["value"].get<double>(), " ", problem.sweep.unit, ", ",
                             (*worst)["direction"].get<std::string>()));
  };
  add("largest force on one contact", "force_ratio_max", 1.0, 1.0, " static forces");
  add("largest pressure", "p_max", 1.0, 1e-9, " GPa");
  add("smallest film", "h_min", -1.0, 1e6, " um");
  add("largest multiplier", "floquet_modulus", 1.0, 1.0, "");
  table.print(comm, problem.run.directory);
}

void print_result(MPI_Comm comm, const CaseInput& problem, const Summary& summary) {
  const int found = summary["points_found"].get<int>(), count = found + summary["points_failed"].get<int>();
  say(comm, found, " of ", count, problem.sweep.marched() ? " marches done" : " periodic states found");
  if (problem.sweep.kind == SweepKind::periodic) print_extremes(comm, problem, summary);
  if (!summary.contains("attractors")) return;
  for (const Summary& attractor : summary["attractors"]) {
    say(comm, std::fixed, std::setprecision(1), std::setw(5), 100.0 * attractor["share"].get<double>(),
        " % of the starts: ", description_of(attractor));
  }
}

/// Throws InputError for a sweep that says too little or asks for what there is not, before any work.
void check_sweep(const CaseInput& problem) {
  require_inertia(problem);
  require_moving_train(problem, "sweep");
  require_moving_contacts(problem, "sweep", true);
  require_one_pattern(problem, "sweep");
  if (problem.sweep.values.empty()) {
    throw InputError("the case '" + problem.name +
                     "' has no range for its sweep; give sweep.from and sweep.to, or sweep.values");
  }
  if (problem.sweep.parameter == "gear.equivalent_mass" && problem.pair.inertias) {
    throw InputError("a sweep over equivalent_mass needs gear.equivalent_mass instead of both inertias");
  }
  if (problem.sweep.kind == SweepKind::basins) return;
  for (double value : problem.sweep.values) (void)case_with_parameter(problem, problem.sweep.parameter, value);
}

/// Summary of a sweep whose points are all on disk.
Summary sweep_summary(MPI_Comm comm, const CaseInput& problem, const SweepPoints& points) {
  Summary results = Summary::array();
  int failures = 0;
  for (const SweepPoint& point : points_of(problem.sweep)) {
    results.push_back(points.read(comm, point).value());
    failures += results.back().contains("error");
  }
  Summary summary = {{"case", problem.name},
                     {"nx", problem.numerics.nx},
                     {"ny", problem.numerics.ny},
                     {"dT", problem.numerics.steps.dT},
                     {"over", problem.sweep.parameter},
                     {"points_found", results.size() - failures},
                     {"points_failed", failures}};
  if (problem.sweep.kind == SweepKind::basins) summary["attractors"] = attractors_of(results);
  summary["points"] = std::move(results);
  return summary;
}

}  // namespace

void run_sweep(MPI_Comm comm, const CaseInput& problem) {
  check_sweep(problem);
  const int groups = group_count(comm, problem);
  const OutputDirectory directory(comm, problem.run.directory);
  if (!problem.pair.teeth.rigid()) warn_of_corner_contact(comm, mesh_after_leaving(problem));
  const SweepPoints points(comm, problem);
  directory.remove_earlier_results();
  const StopRequest stop(problem.run.time_limit);
  run_chains(comm, problem, points, groups, stop);
  if (problem.dry() && !problem.sweep.marched()) mend_sweep(comm, problem, points, points_of(problem.sweep), stop);

  const Summary summary = sweep_summary(comm, problem, points);
  write_sweep_tables(comm, problem, summary["points"]);
  write_summary(comm, problem.run.directory, summary);
  points.complete(comm);
  print_result(comm, problem, summary);
  if (!problem.dry() && problem.sweep.kind == SweepKind::periodic) {
    const CaseInput fastest =
        case_with_parameter(problem, problem.sweep.parameter, std::ranges::max(problem.sweep.values));
    warn_of_heating(comm, fastest, heating_at_pitch(fastest));
  }
  if (summary["points_found"].get<int>() == 0)
    throw SolveError(std::string("no point of the sweep ") +
                     (problem.sweep.marched() ? "was marched" : "has a periodic state") + "; see the errors in " +
                     (problem.run.directory / "summary.json").string());
}

}  // namespace gearfilm
