// Versions of the files that a later program or script may read. A file of another version is refused, not guessed at;
// one without a version comes from a program before they were counted.
//
// Raise a version when an older file would be misread, or a run would go on from it wrongly: when names, units, layout
// or meaning of what it holds change, or the order in which a march asks for its runs. Additions to results need none.
#pragma once

#include <filesystem>

#include "output/summary.hpp"

namespace gearfilm {

/// Version of the files from which a run goes on: run.json with the steps, sweep.json with the points, all state files.
constexpr int restart_format = 13;
/// Version of results.h5, its attribute "format_version" at "/". FORMAT of scripts/gearfilm/folder.py is the same.
constexpr int results_format = 1;

/// Throws InputError where "format" in the content of a file is not restart_format.
void require_restart_format(const Summary& content, const std::filesystem::path& file);

}  // namespace gearfilm
