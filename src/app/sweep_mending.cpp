#include "app/sweep_mending.hpp"

#include "app/sweep_chain.hpp"
#include "input/case_with_parameter.hpp"
#include "results/sweep_point.hpp"

namespace gearfilm {
namespace {

struct Known {
  SweepPoint point;
  Summary result;

  bool found() const { return !result.contains("error"); }
  BranchState state() const {
    const ChainLink link = read_link(result);
    return {link.guess.motion, link.value};
  }
};

/// Those that are found at the same value, then next to it.
std::vector<BranchState> near(const std::vector<Known>& all, const SweepPoint& point) {
  std::vector<BranchState> states;
  for (const long apart : {0L, -1L, 1L}) {
    for (const Known& known : all) {
      const long index = static_cast<long>(point.index) + apart;
      if (known.found() && static_cast<long>(known.point.index) == index) states.push_back(known.state());
    }
  }
  return states;
}

/// The record of a point with the state that is found from another; nothing where there is none.
std::optional<Summary> mended(const ProblemAt& problem_at, const Known& failed, const BranchState& from,
                              const DryWatch& watch) {
  const auto value = failed.result["value"].get<double>();
  const std::optional<DryOrbit> orbit = follow_to_point(problem_at, value, from, watch);
  if (!orbit) return {};
  Summary result = failed.result;
  result.erase("error");
  add_dry_orbit(problem_at(value), {*orbit, from.parameter == value ? "other way" : "point beyond"}, result);
  return result;
}

}  // namespace

void mend_sweep(MPI_Comm comm, const CaseInput& problem, const SweepPoints& points, const std::vector<SweepPoint>& all,
                const StopRequest& stop) {
  const DryWatch watch = counted(stop.check_in(comm));
  const ProblemAt problem_at = problems_of_sweep(cases_of_sweep(problem));
  std::vector<Known> known;
  known.reserve(all.size());
  for (const SweepPoint& point : all) known.push_back({point, points.read(comm, point).value()});
  for (bool again = true; again;) {
    again = false;
    for (Known& failed : known) {
      if (failed.found()) continue;
      for (const BranchState& from : near(known, failed.point)) {
        std::optional<Summary> result = mended(problem_at, failed, from, watch);
        if (!result) continue;
        failed.result = std::move(*result);
        points.write(comm, failed.point, failed.result);
        print_point(comm, problem, failed.result);
        again = true;
        break;
      }
    }
  }
}

}  // namespace gearfilm
