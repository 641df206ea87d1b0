// `gearfilm info`: everything about a case that needs no field solve.
#include "app/commands.hpp"
#include "app/result_warnings.hpp"
#include "output/output_directory.hpp"
#include "output/screen.hpp"
#include "results/derived.hpp"

namespace gearfilm {

void run_info(MPI_Comm comm, const CaseInput& problem) {
  const Summary summary = derived_quantities(problem);
  const OutputDirectory directory(comm, problem.run.directory);
  for (const std::string& line : derived_lines(summary)) say(comm, line);
  write_summary(comm, problem.run.directory, summary);
  warn_of_heating(comm, problem, summary);
}

}  // namespace gearfilm
