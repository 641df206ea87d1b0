#include "input/text_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "input/plain_text.hpp"

namespace gearfilm {
namespace {

constexpr std::streamsize longest_file = 1 << 20;

// The first byte that is no text. A carriage return ends a line only together with a line feed.
std::size_t first_wrong_byte(const std::string& text) {
  std::size_t lone = text.find('\r');
  while (lone != std::string::npos && text.compare(lone, 2, "\r\n") == 0) lone = text.find('\r', lone + 1);
  return std::min(lone, first_unreadable(text, "\t\r\n"));
}

}  // namespace

TextFile read_text_file(const std::string& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) return {"", "does not exist; check its path"};
  if (std::filesystem::is_directory(status)) return {"", "is a directory; give the path of a file"};
  if (!std::filesystem::is_regular_file(status)) return {"", "is not a regular file; give the path of one on disk"};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {"", "cannot be opened; check its permissions"};
  std::string text(longest_file + 1, '\0');
  stream.read(text.data(), longest_file + 1);
  text.resize(stream.gcount());
  if (stream.bad()) return {"", "cannot be read; check the disk"};
  if (stream.gcount() > longest_file) return {"", "is larger than 1 MB, which no such file is; check its path"};
  if (const std::size_t wrong = first_wrong_byte(text); wrong != std::string::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(wrong), '\n');
    return {"", "is not plain text: line " + std::to_string(line) +
                    " has a control character or is not UTF-8; save it as UTF-8"};
  }
  return {std::move(text), ""};
}

}  // namespace gearfilm
