// What `gearfilm info` gives: one record a quantity. The command's table on the screen and the manual are made of them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gearfilm {

struct DerivedRecord {
  std::string_view name;  ///< key in summary.json
  std::string_view symbol;
  std::string_view unit;
  std::string_view meaning;
};

std::span<const DerivedRecord> derived_records();
/// Nothing known of it: an empty record with that name.
DerivedRecord derived_record(std::string_view name);
/// The table of the manual, in Markdown.
std::string derived_markdown();

}  // namespace gearfilm
