// Tables that grow in results.h5: every row once and in order, under its columns' names and units, whatever the number
// of processes.
#include "output/results_table.hpp"

#include <filesystem>

#include "output/output_directory.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// A table as another program reads it, by itself.
struct TableOnDisk {
  std::vector<std::string> names;
  std::vector<bool> integer;
  std::vector<double> values;  ///< row after row
  std::string units;
};

hid_t there(hid_t id) {
  if (id < 0) throw std::runtime_error("HDF5 does not find what it is asked for");
  return id;
}

std::string text_attribute(hid_t dataset, const char* name) {
  const hid_t attribute = there(H5Aopen(dataset, name, H5P_DEFAULT)), type = there(H5Aget_type(attribute));
  EXPECT_TRUE(H5Tis_variable_str(type));
  EXPECT_EQ(H5Tget_cset(type), H5T_CSET_UTF8);
  char* read = nullptr;
  there(H5Aread(attribute, type, static_cast<void*>(&read)));
  const std::string text = read;
  H5free_memory(read);
  H5Tclose(type);
  H5Aclose(attribute);
  return text;
}

TableOnDisk read_table(const std::filesystem::path& path, const char* name) {
  TableOnDisk table;
  const hid_t file = there(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  const hid_t dataset = there(H5Dopen2(file, name, H5P_DEFAULT));
  const hid_t type = there(H5Dget_type(dataset)), space = there(H5Dget_space(dataset));
  const auto width = static_cast<std::size_t>(H5Tget_nmembers(type));
  const hid_t row = there(H5Tcreate(H5T_COMPOUND, width * sizeof(double)));
  for (unsigned n = 0; n < width; ++n) {
    char* column = H5Tget_member_name(type, n);
    there(H5Tinsert(row, column, n * sizeof(double), H5T_NATIVE_DOUBLE));
    table.names.emplace_back(column);
    table.integer.push_back(H5Tget_member_class(type, n) == H5T_INTEGER);
    H5free_memory(column);
  }
  table.values.resize(width * H5Sget_simple_extent_npoints(space));
  there(H5Dread(dataset, row, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()));
  table.units = text_attribute(dataset, "units");
  for (const hid_t used : {row, type}) H5Tclose(used);
  H5Sclose(space);
  H5Dclose(dataset);
  H5Fclose(file);
  return table;
}

/// A file of the test's own, common to all processes.
class ResultsTableTest : public testing::Test {
protected:
  ResultsTableTest() {
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank_);
    MPI_Comm_size(PETSC_COMM_WORLD, &processes_);
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() /
            ("gearfilm_" + std::string(test->name()) + "_" + std::to_string(processes_) + ".h5");
    left_ = path_.string() + ".left";
  }
  ~ResultsTableTest() override {
    MPI_Barrier(PETSC_COMM_WORLD);
    std::error_code ignored;
    if (rank_ != 0) return;
    for (const auto& path : {path_, part_of(path_), left_}) std::filesystem::remove(path, ignored);
  }

  /// So many rows from a number on. The last column is a process's own, as the time is that a step took.
  std::vector<double> rows(int first, int count, int process) const {
    std::vector<double> values;
    for (int n = first; n < first + count; ++n) {
      for (const double value : {static_cast<double>(n), n / 3.0, n / 7.0 + 1000.0 * process}) values.push_back(value);
    }
    return values;
  }

  static constexpr const char* name_ = "/history/steps";
  const std::vector<TableColumn> columns_ = {{"step", "-", true}, {"force", "N"}, {"wall_time", "s"}};
  std::filesystem::path path_;
  std::filesystem::path left_;  ///< copy of what a killed run would leave
  int rank_ = 0;
  int processes_ = 1;
};

TEST_F(ResultsTableTest, has_every_row_once_and_in_order) {
  ResultsFile file(PETSC_COMM_WORLD, path_);
  int length = 0;
  {
    ResultsTable table(file, name_, columns_);
    // Some wait for the next write, some have a write to themselves, and one batch is longer than a chunk of the file.
    for (const auto& [count, written] :
         {std::pair{1, true}, {2, false}, {3, true}, {0, true}, {600, false}, {5, false}, {1, true}, {4, true}}) {
      table.append(rows(length, count, rank_));
      length += count;
      if (written) table.write();
    }
    table.write();  // nothing waits
  }
  file.finish();
  if (rank_ != 0) return;
  const TableOnDisk table = read_table(path_, name_);
  EXPECT_EQ(table.values, rows(0, length, 0));
}

TEST_F(ResultsTableTest, names_its_columns_and_their_units) {
  ResultsFile file(PETSC_COMM_WORLD, path_);
  {
    ResultsTable table(file, name_, columns_);
    table.append(rows(0, 1, rank_));
    table.write();
  }
  file.finish();
  if (rank_ != 0) return;
  const TableOnDisk table = read_table(path_, name_);
  EXPECT_EQ(table.names, (std::vector<std::string>{"step", "force", "wall_time"}));
  EXPECT_EQ(table.integer, (std::vector<bool>{true, false, false}));
  EXPECT_EQ(table.units, "step -\nforce N\nwall_time s\n");
}

// HDF5 by itself would have the first process wait in some of these rows for the others, for ever.
TEST_F(ResultsTableTest, takes_rows_after_any_amount_of_metadata) {
  constexpr int fewest_groups = 200, rounds = 100;
  ResultsFile file(PETSC_COMM_WORLD, path_);
  {
    ResultsTable table(file, name_, columns_);
    for (int round = 0; round < rounds; ++round) {
      for (int n = 0; n < fewest_groups + round; ++n) {
        file.attribute("/" + std::to_string(round) + "/" + std::to_string(n), "number", n);
      }
      table.append(rows(round, 1, rank_));
      table.write();
    }
  }
  file.finish();
  if (rank_ != 0) return;
  EXPECT_EQ(read_table(path_, name_).values, rows(0, rounds, 0));
}

// A run that is killed leaves them.
TEST_F(ResultsTableTest, has_written_rows_before_its_file_is_finished) {
  bool copied = false;
  ResultsFile file(PETSC_COMM_WORLD, path_);
  {
    ResultsTable table(file, name_, columns_);
    table.append(rows(0, 2, rank_));
    table.append(rows(2, 5, rank_));
    table.write();
    MPI_Barrier(PETSC_COMM_WORLD);
    std::error_code failure;
    constexpr auto replacing = std::filesystem::copy_options::overwrite_existing;
    if (rank_ == 0) copied = std::filesystem::copy_file(part_of(path_), left_, replacing, failure);
    MPI_Barrier(PETSC_COMM_WORLD);
  }
  file.finish();
  if (rank_ != 0) return;
  ASSERT_TRUE(copied);
  EXPECT_EQ(read_table(left_, name_).values, rows(0, 7, 0));
}

}  // namespace
}  // namespace gearfilm
