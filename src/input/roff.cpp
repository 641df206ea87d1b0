#include "input/roff.hpp"

namespace gearfilm {

std::string roff_text(const std::string& text) {
  std::string roff;
  for (const char character : text) {
    const bool begins_line = roff.empty() || roff.back() == '\n';
    if (begins_line && (character == '.' || character == '\'')) roff += "\\&";
    if (character == '-') {
      roff += "\\-";
    } else if (character == '\\') {
      roff += "\\e";
    } else if (character == '\'') {
      roff += "\\(aq";
    } else if (character == '^') {
      roff += "\\(ha";
    } else if (character == '~') {
      roff += "\\(ti";
    } else {
      roff += character;
    }
  }
  return roff;
}

std::string roff_entry(const std::string& term, const std::string& kind, const std::string& meaning) {
  return ".TP\n\\fB" + roff_text(term) + "\\fR" + (kind.empty() ? "" : " \\fI" + roff_text(kind) + "\\fR") + "\n" +
         roff_text(meaning) + "\n";
}

}  // namespace gearfilm
