// The parameters of the run whose results a folder holds: another run must not be mixed with these, or go on from them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/case.hpp"
#include "output/results_file.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// The command and all parameters but those that may differ: names, or whole sections ("time").
Summary identity_of(const CaseInput& problem, const std::string& command, const std::vector<std::string>& free);

/// Writes the file, with the version of its format. Throws OutputError. Collective, as are the others.
void keep_identity(MPI_Comm comm, const std::filesystem::path& file, Summary identity);
/// Nothing where the file is missing. Throws InputError where it cannot be read, or is of another format version.
std::optional<Summary> read_identity(MPI_Comm comm, const std::filesystem::path& file);
/// Throws InputError that names the first difference. file: where the earlier identity stands.
void require_same_identity(const Summary& before, const Summary& now, const std::filesystem::path& file);

/// Program, provenance, command and all parameters as attributes of a results file.
void write_identity(ResultsFile& file, const CaseInput& problem, const std::string& command);

}  // namespace gearfilm
