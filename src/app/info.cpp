// `gearfilm info`: everything about a case that needs no field solve.
#include "gearfilm/app/commands.hpp"
#include "gearfilm/app/derived.hpp"
#include "gearfilm/output/output_directory.hpp"

namespace gearfilm {

void run_info(MPI_Comm comm, const Case& problem) {
  const Summary summary = derived_quantities(problem);
  const OutputDirectory directory(comm, problem.run.directory);
  for (const auto& [name, value] : summary.items()) {
    if (value.is_number()) {
      petsc_check(PetscPrintf(comm, "%-36s %.8g\n", name.c_str(), value.get<double>()));
    } else {
      petsc_check(PetscPrintf(comm, "%-36s %s\n", name.c_str(), value.get<std::string>().c_str()));
    }
  }
  write_summary(comm, problem.run.directory, summary);
}

}  // namespace gearfilm
