// Small text files that a user names: cases and tables.
#pragma once

#include <string>

namespace gearfilm {

struct TextFile {
  std::string text;
  std::string obstacle;  ///< why it cannot be used, and what to do; empty where it can
};

/// Reads a regular file of at most 1 MB of plain text on the calling process. Never waits, as for a pipe.
TextFile read_text_file(const std::string& file);

}  // namespace gearfilm
