// `gearfilm info`: everything about a case that needs no field solve.
#include <iomanip>
#include <sstream>

#include "app/commands.hpp"
#include "app/derived.hpp"
#include "app/derived_records.hpp"
#include "app/result_warnings.hpp"
#include "output/output_directory.hpp"

namespace gearfilm {

void run_info(MPI_Comm comm, const Case& problem) {
  const Summary summary = derived_quantities(problem);
  const OutputDirectory directory(comm, problem.run.directory);
  for (const auto& [name, value] : summary.items()) {
    const DerivedRecord record = derived_record(name);
    std::ostringstream line;
    line << std::left << std::setw(36) << name << std::setprecision(8) << std::setw(16);
    if (value.is_number()) {
      line << value.get<double>();
    } else {
      line << value.get<std::string>();
    }
    const std::string symbol = record.symbol.empty() ? "" : std::string(record.symbol) + ": ";
    line << " " << std::setw(5) << record.unit << " " << symbol << record.meaning;
    petsc_check(PetscPrintf(comm, "%s\n", line.str().c_str()));
  }
  write_summary(comm, problem.run.directory, summary);
  warn_of_heating(comm, problem, summary);
}

}  // namespace gearfilm
