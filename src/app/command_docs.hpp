// The table of commands and that of parameters as text. The manual page and the completion are made of it
// (scripts/packaging/manual.py).
#pragma once

#include <string>

namespace gearfilm {

/// What -help prints.
std::string help_text();

}  // namespace gearfilm
