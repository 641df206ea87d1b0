// Which files this program may remove or replace: those that it wrote itself, known by their content, not by their
// names.
//
//   summary.json              JSON object with "provenance"
//   run.json, sweep.json      JSON object with "command" and "case.kind", likewise wear.json
//   points/*.json             JSON object with "direction" and "value"
//   results.h5                HDF5 file with the attribute "format_version"; one that a killed march left damaged,
//   where
//                             the march's checkpoint/run.json stands beside it
//   results.xmf, shares.txt   their first lines
//   steps, *.state, *.guesses the mark of restart_mark.hpp
//   *.part                    a beginning of one of these, however short: a write that was interrupted;
//                             results.h5.part by its name
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "parallel/petsc.hpp"

namespace gearfilm {

/// The table of load shares that `static` leaves, and how it begins.
constexpr std::string_view shares_name = "shares.txt";
constexpr std::string_view shares_head = "# position on the line of action [m] and share of the load";

/// Whether this program wrote the file. False for links, folders, and files that cannot be read.
bool written_here(const std::filesystem::path& file);

/// Throws InputError on all processes where one of the files exists and was not written by this program. Collective.
void require_replaceable(MPI_Comm comm, const std::vector<std::filesystem::path>& files);

/// Throws InputError on all processes where a folder, with all folders in it, holds anything that this program did not
/// write. Collective.
void require_removable(MPI_Comm comm, const std::filesystem::path& folder);

/// Removes the file if this program wrote it; for the process that does so alone.
void remove_if_written_here(const std::filesystem::path& file);

/// Removes what this program wrote in a folder and in the folders in it, then those that are empty; for the process
/// that does so alone. A link to a folder stays.
void remove_all_written_here(const std::filesystem::path& folder);

}  // namespace gearfilm
