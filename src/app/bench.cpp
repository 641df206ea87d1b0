// `gearfilm bench`: speed of the kernels, of stationary films and of a mesh period.
#include <algorithm>
#include <vector>

#include "app/commands.hpp"
#include "bench/grid_bench.hpp"
#include "input/case_setup.hpp"
#include "output/output_directory.hpp"

namespace gearfilm {

void run_bench(MPI_Comm comm, const CaseInput& problem) {
  constexpr GridSize standard_grids[] = {{129, 65}, {129, 129}, {257, 257}, {513, 513}};
  require_moving_contacts(problem, "bench", false);
  require_moving_train(problem, "bench");
  if (problem.pair.line && problem.pair.equivalent_mass) require_one_pattern(problem, "bench");
  const OutputDirectory directory(comm, problem.run.directory);
  Summary summary;
  summary["case"] = problem.name;
  summary["grids"] = Summary::array();
  std::vector<GridSize> measured;
  for (const GridSize standard : standard_grids) {
    const CaseInput resized = on_grid(problem, standard);
    const GridSize size = size_of(resized);
    if (std::ranges::find(measured, size) != measured.end()) continue;
    measured.push_back(size);
    summary["grids"].push_back(bench_grid(comm, resized));
  }
  if (problem.pair.line && problem.pair.equivalent_mass) summary.update(bench_pair(comm, problem, run_periodic));
  write_summary(comm, problem.run.directory, summary);
}

}  // namespace gearfilm
