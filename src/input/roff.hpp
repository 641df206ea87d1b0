// Text for the manual page, in the language of troff with its macros "man".
#pragma once

#include <string>

namespace gearfilm {

/// Plain text as roff: dashes and backslashes as themselves, no line that begins like a request.
std::string roff_text(const std::string& text);

/// A term, its kind in italics behind it, and what it means below; all plain text.
std::string roff_entry(const std::string& term, const std::string& kind, const std::string& meaning);

}  // namespace gearfilm
