// A table in results.h5 that grows row by row and survives a killed run.
//
// One compound dataset a table, so that h5py, pandas and MATLAB see named columns; the attribute "units" lists
// "column unit" lines. Rows wait in memory for up to half a second, or until write(); then the first process writes
// them. What still waits when the table goes is lost.
#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "output/results_file.hpp"

namespace gearfilm {

struct TableColumn {
  std::string name;
  std::string unit;      ///< "-" for pure numbers
  bool integer = false;  ///< stored as a whole number
};

class ResultsTable {
public:
  /// Creates an empty table at a path such as "/history/steps". The file must outlive the table. Collective.
  ResultsTable(ResultsFile& file, const std::string& path, const std::vector<TableColumn>& columns);
  ~ResultsTable();
  ResultsTable(const ResultsTable&) = delete;
  ResultsTable& operator=(const ResultsTable&) = delete;

  /// Appends whole rows (values row after row, one a column). Collective. Writes at most twice a second.
  void append(const std::vector<double>& rows);
  /// Writes what waits. Collective.
  void write();

private:
  void create(const std::string& path, const std::vector<TableColumn>& columns);
  void put_rows(const std::vector<double>& rows);

  ResultsFile& file_;
  hid_t dataset_ = H5I_INVALID_HID;
  hid_t memory_type_ = H5I_INVALID_HID;
  std::size_t width_;
  hsize_t length_ = 0;  ///< rows in the file
  std::vector<double> waiting_;
  double last_write_ = 0.0;
};

/// A whole table at once. Collective.
void write_table(ResultsFile& file, const std::string& path, const std::vector<TableColumn>& columns,
                 const std::vector<double>& rows);

}  // namespace gearfilm
