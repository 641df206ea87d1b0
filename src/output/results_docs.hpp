// The tables of figures as text.
#pragma once

#include <string>

namespace gearfilm {

/// The content of docs/results.md: columns of the history, figures of a mesh period.
std::string figures_markdown();

}  // namespace gearfilm
