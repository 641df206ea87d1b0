// summary.json: the main results of a run, values in SI, dimensionless ones under their symbol.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "gearfilm/parallel/petsc.hpp"

namespace gearfilm {

/// Keeps the order in which results were added.
using Summary = nlohmann::ordered_json;

/// Writes the file (first process); throws SolveError, and writes nothing, where a number is not finite.
void write_json(MPI_Comm comm, const std::filesystem::path& path, const Summary& values);

/// Writes summary.json of a folder, with the provenance of the results (provenance.hpp) behind them.
void write_summary(MPI_Comm comm, const std::filesystem::path& folder, Summary summary);

}  // namespace gearfilm
