// Lists of small integers in few bytes: of a field whose neighbours differ little and of which much is zero, a fifth to
// a third of what it has otherwise.
//
// Each is kept as the difference d from the one before it, modulo 2^16, as the number 2 d or -2 d - 1 in one to three
// bytes of seven bits, the lowest first, the highest bit of a byte telling that another follows. A byte of zero is
// followed by the number of further zero differences, up to 255.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gearfilm {

std::vector<std::uint8_t> packed(std::span<const std::int16_t> integers);

/// The integers of a list that packed() has made.
std::vector<std::int16_t> unpacked(std::span<const std::uint8_t> bytes, std::size_t count);

}  // namespace gearfilm
