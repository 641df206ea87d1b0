// `gearfilm info`: everything about a case that needs no field solve.
#include "app/commands.hpp"
#include "app/result_warnings.hpp"
#include "output/output_directory.hpp"
#include "output/screen.hpp"
#include "results/derived.hpp"
#include "results/derived_records.hpp"

namespace gearfilm {

void run_info(MPI_Comm comm, const CaseInput& problem) {
  const Summary summary = derived_quantities(problem);
  const OutputDirectory directory(comm, problem.run.directory);
  for (const auto& [name, value] : summary.items()) {
    const DerivedRecord record = derived_record(name);
    const std::string text =
        value.is_number() ? worded(std::setprecision(8), value.get<double>()) : value.get<std::string>();
    say(comm, std::left, std::setw(36), name, std::setw(16), text, " ", std::setw(5), record.unit, " ", record.symbol,
        record.symbol.empty() ? "" : ": ", record.meaning);
  }
  write_summary(comm, problem.run.directory, summary);
  warn_of_heating(comm, problem, summary);
}

}  // namespace gearfilm
