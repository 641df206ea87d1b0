#include "dynamics/packed_integers.hpp"

#include <algorithm>

namespace gearfilm {

std::vector<std::uint8_t> packed(std::span<const std::int16_t> integers) {
  constexpr std::size_t most_bytes = 3, most_zeros = 255;
  std::vector<std::uint8_t> bytes(most_bytes * integers.size());
  auto next = bytes.begin();
  std::int16_t last = 0;
  for (std::size_t n = 0; n < integers.size();) {
    if (integers[n] == last) {
      const std::size_t end = std::min(integers.size(), n + 1 + most_zeros), first = n++;
      while (n < end && integers[n] == last) ++n;
      *next++ = 0;
      *next++ = static_cast<std::uint8_t>(n - first - 1);
      continue;
    }
    const auto difference = static_cast<std::int16_t>(integers[n] - last);
    auto number = static_cast<std::uint16_t>((difference * 2) ^ (difference >> 15));
    last = integers[n++];
    for (; number > 127; number >>= 7) *next++ = static_cast<std::uint8_t>(number | 128);
    *next++ = static_cast<std::uint8_t>(number);
  }
  return {bytes.begin(), next};
}

std::vector<std::int16_t> unpacked(std::span<const std::uint8_t> bytes, std::size_t count) {
  std::vector<std::int16_t> integers(count);
  auto next = bytes.begin();
  std::int16_t last = 0;
  for (std::size_t n = 0; n < count;) {
    if (*next == 0) {
      const std::size_t zeros = next[1] + 1U;
      std::fill_n(integers.begin() + static_cast<std::ptrdiff_t>(n), zeros, last);
      n += zeros;
      next += 2;
      continue;
    }
    unsigned number = 0;
    int shift = 0;
    for (; *next > 127; shift += 7) number |= (*next++ & 127U) << shift;
    number |= static_cast<unsigned>(*next++) << shift;
    last = static_cast<std::int16_t>(last + static_cast<std::int16_t>((number >> 1) ^ -(number & 1U)));
    integers[n++] = last;
  }
  return integers;
}

}  // namespace gearfilm
