#include "input/plain_text.hpp"

namespace gearfilm {
namespace {

// Bytes of the character that begins a text; 0 where none does, or a control character. UTF-8 as in RFC 3629.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t n) -> unsigned {
    return n < text.size() ? static_cast<unsigned char>(text[n]) : 0;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  unsigned code = lead & (0x7f >> length);
  for (std::size_t n = 1; n < length; ++n) {
    if ((byte(n) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(n) & 0x3f);
  }
  constexpr unsigned smallest[] = {0, 0, 0xa0, 0x800, 0x10000};  // U+0080 to U+009F are control characters
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return code >= smallest[length] && code <= 0x10ffff && !surrogate ? length : 0;
}

}  // namespace

std::size_t first_unreadable(std::string_view text, std::string_view allowed) {
  for (std::size_t n = 0; n < text.size();) {
    const std::size_t length = allowed.find(text[n]) != std::string_view::npos ? 1 : character_length(text.substr(n));
    if (length == 0) return n;
    n += length;
  }
  return std::string_view::npos;
}

std::string one_line(std::string_view text) {
  constexpr std::size_t longest = 1200, kept_end = 300;
  std::string line(text);
  if (line.size() > longest) {
    const std::size_t cut = line.size() - longest;
    line.replace(longest - kept_end, cut, " [... " + std::to_string(cut) + " bytes ...] ");
  }
  for (std::size_t n = 0; (n = first_unreadable(line)) != std::string::npos;) line[n] = line[n] == '\n' ? ' ' : '?';
  return line;
}

}  // namespace gearfilm
