// The folder that receives the results of one run.
#pragma once

#include <filesystem>

#include "gearfilm/ehl/petsc.hpp"

namespace gearfilm {

/// Creates the folder where it is missing and makes sure that files can be written into it. Throws InputError on all
/// processes alike where that is not so.
void prepare_output_directory(MPI_Comm comm, const std::filesystem::path& directory);

/// Removes results.h5, results.xmf and summary.json of an earlier run, which would outlive a failure of this one.
void remove_earlier_results(MPI_Comm comm, const std::filesystem::path& directory);

/// Files are written as part_of(path) and renamed when whole, so that a reader never meets half a file. Collective.
std::filesystem::path part_of(const std::filesystem::path& path);
void finish_part(MPI_Comm comm, const std::filesystem::path& path);

}  // namespace gearfilm
