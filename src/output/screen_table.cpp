#include "output/screen_table.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "gearfilm/error.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {
namespace {

constexpr int digits = 5;

std::string formatted(double value, int precision) { return worded(std::setprecision(precision), value); }

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

/// "DIR: summary.json, results.h5", of those that are there.
std::string files_in(const std::filesystem::path& folder) {
  std::string text;
  for (const char* name : {"summary.json", "results.h5", "results.xmf"}) {
    std::error_code ignored;
    if (std::filesystem::exists(folder / name, ignored)) text += (text.empty() ? "" : ", ") + std::string(name);
  }
  return folder.string().append(": ").append(text);
}

}  // namespace

ScreenTable& ScreenTable::add(const std::string& label, const std::string& key, double factor,
                              const std::string& unit) {
  return add(summary_, label, key, factor, unit);
}

ScreenTable& ScreenTable::add(const Summary& summary, const std::string& label, const std::string& key, double factor,
                              const std::string& unit) {
  const auto found = summary.find(key);
  if (found == summary.end() || !found->is_number()) return *this;
  const auto error = summary.find(key + "_error");
  const bool known = error != summary.end() && error->is_number();
  rows_.push_back({label, formatted(factor * found->get<double>(), digits),
                   known ? std::string("+- ").append(formatted(factor * error->get<double>(), 2)) : "", unit});
  return *this;
}

ScreenTable& ScreenTable::text(const std::string& label, const std::string& value) {
  rows_.push_back({label, value, "", ""});
  return *this;
}

void ScreenTable::print(MPI_Comm comm, const std::filesystem::path& folder) const {
  const std::string place = "results in";
  std::size_t label = place.size(), value = 0, error = 0;
  for (const Row& row : rows_) {
    label = std::max(label, row.label.size());
    error = std::max(error, row.error.size());
    if (!row.unit.empty() || !row.error.empty()) value = std::max(value, row.value.size());
  }
  std::string text;
  for (const Row& row : rows_) {
    std::string line = padded(row.label, label + 2) + padded(row.value, value);
    if (error > 0) line.append(" ").append(padded(row.error, error));
    line.append(" ").append(row.unit);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  petsc_check(PetscPrintf(comm, "%s%s%s\n", text.c_str(), padded(place, label + 2).c_str(), files_in(folder).c_str()));
}

}  // namespace gearfilm
