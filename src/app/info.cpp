// `gearfilm info`: everything about a case that needs no field solve.
#include "app/commands.hpp"
#include "app/result_warnings.hpp"
#include "output/output_directory.hpp"
#include "output/screen.hpp"
#include "results/derived.hpp"
#include "results/tilt_summary.hpp"
#include "results/train_summary.hpp"

namespace gearfilm {

void run_info(MPI_Comm comm, const CaseInput& problem) {
  Summary summary = derived_quantities(problem);
  std::vector<std::string> lines = derived_lines(summary), warnings;
  if (problem.pair.train) {
    const DampedTrain train = damped_train_of(problem);
    add_train(problem, train, {}, summary);
    warnings = train_warnings(problem, train);
    if (problem.pair.tilt) lines.push_back(tilt_line(problem));
    for (const auto& more : {mode_lines(summary), damping_lines(summary)}) {
      lines.insert(lines.end(), more.begin(), more.end());
    }
  }
  const OutputDirectory directory(comm, problem.run.directory);
  for (const std::string& line : lines) say(comm, line);
  write_summary(comm, problem.run.directory, summary);
  warn_of_heating(comm, problem, summary);
  for (const std::string& warning : warnings) warn(comm, warning);
}

}  // namespace gearfilm
