// The first 16 bytes of every binary file of a checkpoint, by which this program knows its own (file_ownership.hpp).
#pragma once

#include <string_view>

namespace gearfilm {

constexpr std::string_view restart_mark = "gearfilm restart";
static_assert(restart_mark.size() == 16);

}  // namespace gearfilm
