// Versions of the files that a later program or script may read. A file of another version is refused, not guessed at;
// one without a version comes from a program before they were counted.
//
// Raise a version when a file of before would be misread, or gone on from wrongly: names, units, layout or meaning of
// what it holds, or the order in which a march asks for its runs. What is merely added to results needs none.
#pragma once

#include <filesystem>

#include "output/summary.hpp"

namespace gearfilm {

/// Of what a run goes on from: run.json, with the steps beside it; sweep.json, with the points; every state file.
constexpr int restart_format = 9;
/// Of results.h5, attribute "format_version" at "/". FORMAT of scripts/gearfilm/folder.py is the same.
constexpr int results_format = 1;

/// Throws InputError where "format" in the content of a file is not restart_format.
void require_restart_format(const Summary& content, const std::filesystem::path& file);

}  // namespace gearfilm
