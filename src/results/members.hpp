// A result's members, each described once: its name, unit and meaning, and where its value comes from. Summaries,
// tables in results.h5, the screen and docs/results.md are made by visiting such tables.
#pragma once

#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "output/results_table.hpp"
#include "output/summary.hpp"

namespace gearfilm {

template <class Result>
struct Member {
  std::string_view name;    ///< key of the summary, and of a column
  std::string_view symbol;  ///< of the theory, or empty
  std::string_view unit;    ///< "-" for pure numbers; empty for what is no number
  std::string_view meaning;
  Summary (*value)(const Result&);  ///< in SI; null: not known; absent(): the result has none
  bool in_sweep = false;            ///< a column of the table /sweep too
};

/// The value of a member that a result does not have.
inline Summary absent() { return Summary(Summary::value_t::discarded); }  // braces would make it a list of one
/// What may not be known, and what may not be there.
template <class Value>
Summary known(const std::optional<Value>& value) {
  return value ? Summary(*value) : Summary();
}
template <class Value>
Summary if_there(const std::optional<Value>& value) {
  return value ? Summary(*value) : absent();
}

/// Adds all members that the result has.
template <class Members, class Result>
void add_members(const Members& members, const Result& result, Summary& summary) {
  for (const auto& member : members) {
    Summary value = member.value(result);
    if (!value.is_discarded()) summary[std::string(member.name)] = std::move(value);
  }
}

/// The columns of /sweep among them.
template <class Members>
std::vector<TableColumn> sweep_columns(const Members& members) {
  std::vector<TableColumn> columns;
  for (const auto& member : members) {
    if (member.in_sweep)
      columns.push_back({std::string(member.name), member.unit.empty() ? "-" : std::string(member.unit)});
  }
  return columns;
}

/// A table of the manual, in Markdown.
template <class Members>
std::string members_markdown(std::string_view title, std::string_view introduction, const Members& members) {
  std::ostringstream text;
  text << "\n## " << title << "\n\n" << introduction << "\n\n| Key | Symbol | Unit | Meaning |\n|---|---|---|---|\n";
  for (const auto& member : members) {
    text << "| `" << member.name << "` | ";
    if (!member.symbol.empty()) text << "`" << member.symbol << "` ";
    text << "| " << member.unit << (member.unit.empty() ? "| " : " | ") << member.meaning;
    text << (member.in_sweep ? "; also a column of `/sweep`" : "") << " |\n";
  }
  return text.str();
}

}  // namespace gearfilm
