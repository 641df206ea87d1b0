// A result's members, each described once: its name, unit and meaning, and where its value comes from. Summaries,
// tables in results.h5, the screen and docs/results.md are made by visiting such tables.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "output/results_table.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Whether a member is a column of the table of such results in results.h5, and of which numbers.
/// film: real, and left out of the tables of dry pairs.
enum class Column { none, real, whole, film };

template <class Result>
struct Member {
  std::string_view name;    ///< key of the summary, and of a column
  std::string_view symbol;  ///< as in docs/symbols.md, or empty
  std::string_view unit;    ///< "-" for pure numbers; empty for what is no number
  std::string_view meaning;
  Summary (*value)(const Result&);  ///< in SI; null: not known; absent(): the result has none
  Column column = Column::none;
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

inline bool is_in_table(Column column, bool lubricated) {
  return column != Column::none && (lubricated || column != Column::film);
}

/// The members that are columns, of a pair on films or a dry one.
template <class Members>
std::vector<TableColumn> columns_of(const Members& members, bool lubricated = true) {
  std::vector<TableColumn> columns;
  for (const auto& member : members) {
    if (!is_in_table(member.column, lubricated)) continue;
    const std::string_view unit = member.unit.empty() ? "-" : member.unit;
    columns.push_back({std::string(member.name), std::string(unit), member.column == Column::whole});
  }
  return columns;
}

/// A value in a row: NaN for what is not known or not there, 0 or 1 for what is true or not.
inline double in_row(const Summary& value) {
  if (value.is_null() || value.is_discarded()) return std::numeric_limits<double>::quiet_NaN();
  return value.is_boolean() ? static_cast<double>(value.get<bool>()) : value.get<double>();
}

/// Adds the values of its columns to a row.
template <class Members, class Result>
void add_to_row(const Members& members, const Result& result, std::vector<double>& row, bool lubricated = true) {
  for (const auto& member : members) {
    if (is_in_table(member.column, lubricated)) row.push_back(in_row(member.value(result)));
  }
}

/// All that the result has, as an object.
template <class Members, class Result>
Summary as_summary(const Members& members, const Result& result) {
  Summary summary = Summary::object();
  add_members(members, result, summary);
  return summary;
}

/// A table of the manual, in Markdown. table: in results.h5, where not all members are its columns.
template <class Members>
std::string members_markdown(std::string_view title, std::string_view introduction, const Members& members,
                             std::string_view table = {}) {
  std::ostringstream text;
  text << "\n## " << title << "\n\n" << introduction << "\n\n| Key | Symbol | Unit | Meaning |\n|---|---|---|---|\n";
  for (const auto& member : members) {
    text << "| `" << member.name << "` | ";
    if (!member.symbol.empty()) text << "`" << member.symbol << "` ";
    text << "| " << member.unit << (member.unit.empty() ? "| " : " | ") << member.meaning;
    text << (member.column == Column::none || table.empty() ? "" : "; also a column of ")
         << (member.column == Column::none ? "" : table) << " |\n";
  }
  return text.str();
}

}  // namespace gearfilm
