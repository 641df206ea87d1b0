// The tables of quantities as text.
#pragma once

#include <string>

namespace gearfilm {

/// The content of docs/results.md: columns of the history, quantities of a mesh period.
std::string quantities_markdown();

}  // namespace gearfilm
