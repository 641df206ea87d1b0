// Texts about the program as a whole, made from the tables of commands and parameters.
#pragma once

#include <string>

namespace gearfilm {

/// The content of -help.
std::string help_text();

/// The manual page gearfilm(1).
std::string manual_page();

/// A script for bash that completes commands, options, their choices and case files.
std::string bash_completion();

}  // namespace gearfilm
