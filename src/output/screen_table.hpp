// The short table with which a command ends: main quantities with units and error bars, and where the results are.
#pragma once

#include <petscsys.h>

#include <filesystem>
#include <string>
#include <vector>

#include "output/summary.hpp"

namespace gearfilm {

class ScreenTable {
public:
  /// The quantities are looked up in a summary, in SI.
  explicit ScreenTable(Summary summary) : summary_(std::move(summary)) {}

  /// A quantity times a factor, with its error where there is one (`KEY_error`); nothing where the summary has none.
  ScreenTable& add(const std::string& label, const std::string& key, double factor = 1.0, const std::string& unit = "");
  /// Adds a value of another summary.
  ScreenTable& add(const Summary& summary, const std::string& label, const std::string& key, double factor = 1.0,
                   const std::string& unit = "");
  ScreenTable& text(const std::string& label, const std::string& value);

  /// Prints the table on the first process, then the files of the results.
  void print(MPI_Comm comm, const std::filesystem::path& folder) const;

private:
  struct Row {
    std::string label, value, error, unit;
  };
  Summary summary_;
  std::vector<Row> rows_;
};

}  // namespace gearfilm
