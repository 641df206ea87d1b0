// Text as people read it: UTF-8 without control characters. What a user gives comes back in messages and in results,
// where other bytes break terminals and JSON.
#pragma once

#include <string>
#include <string_view>

namespace gearfilm {

/// Where the first byte stands that belongs to no readable character; npos where there is none. Control characters
/// are readable only if they are among the allowed ones.
std::size_t first_unreadable(std::string_view text, std::string_view allowed = {});

/// The text for one line of a terminal: what is unreadable becomes '?', and a very long text loses its middle.
std::string one_line(std::string_view text);

/// A key in a message.
inline std::string in_quotes(const std::string& name) { return "'" + name + "'"; }

}  // namespace gearfilm
