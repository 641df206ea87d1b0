#include "gearfilm/output/results_table.hpp"

#include <stdexcept>
#include <utility>

namespace gearfilm {
namespace {

hid_t valid(hid_t id, const char* what) {
  if (id < 0) throw std::runtime_error(std::string("HDF5 cannot ") + what);
  return id;
}

void succeed(herr_t status, const char* what) {
  if (status < 0) throw std::runtime_error(std::string("HDF5 cannot ") + what);
}

/// Closes an HDF5 identifier at the end of a scope.
class Closing {
public:
  Closing(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Closing() { close_(id_); }
  Closing(const Closing&) = delete;
  Closing& operator=(const Closing&) = delete;
  operator hid_t() const { return id_; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

constexpr hsize_t rows_per_chunk = 256;
constexpr double seconds_between_writes = 0.5;

}  // namespace

ResultsTable::ResultsTable(ResultsFile& file, const std::string& path, const std::vector<TableColumn>& columns)
    : file_(file), width_(columns.size()) {
  std::string units;
  for (const TableColumn& column : columns) units += column.name + " " + column.unit + "\n";
  file_.write([&] { create(path, columns); });
  file_.dataset_attribute(path, "units", units);
}

void ResultsTable::create(const std::string& path, const std::vector<TableColumn>& columns) {
  memory_type_ = valid(H5Tcreate(H5T_COMPOUND, width_ * sizeof(double)), "create a table type");
  std::size_t file_width = 0;
  for (const TableColumn& column : columns) file_width += column.integer ? sizeof(int) : sizeof(double);
  const Closing file_type(valid(H5Tcreate(H5T_COMPOUND, file_width), "create a table type"), H5Tclose);
  std::size_t file_offset = 0;
  for (std::size_t n = 0; n < width_; ++n) {
    const TableColumn& column = columns[n];
    succeed(H5Tinsert(memory_type_, column.name.c_str(), n * sizeof(double), H5T_NATIVE_DOUBLE), "add a column");
    const hid_t type = column.integer ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE;
    succeed(H5Tinsert(file_type, column.name.c_str(), file_offset, type), "add a column");
    file_offset += H5Tget_size(type);
  }
  const hsize_t empty = 0, unlimited = H5S_UNLIMITED, chunk = rows_per_chunk;
  const Closing space(valid(H5Screate_simple(1, &empty, &unlimited), "create a table"), H5Sclose);
  const Closing layout(valid(H5Pcreate(H5P_DATASET_CREATE), "create a table"), H5Pclose);
  succeed(H5Pset_chunk(layout, 1, &chunk), "create a table");
  const Closing links(valid(H5Pcreate(H5P_LINK_CREATE), "create a table"), H5Pclose);
  succeed(H5Pset_create_intermediate_group(links, 1), "create a table");
  dataset_ = valid(H5Dcreate2(file_.hdf5_file(), path.c_str(), file_type, space, links, layout, H5P_DEFAULT),
                   "create a table");
}

ResultsTable::~ResultsTable() {
  if (!file_.damaged()) H5Dclose(dataset_);
  H5Tclose(memory_type_);
}

void ResultsTable::append(const std::vector<double>& rows) {
  waiting_.insert(waiting_.end(), rows.begin(), rows.end());
  // Writing and waiting for the disk takes as long as a small time step; the first process decides for all.
  int due = MPI_Wtime() - last_write_ > seconds_between_writes;
  MPI_Bcast(&due, 1, MPI_INT, 0, file_.comm());
  if (!due) return;
  write();
  last_write_ = MPI_Wtime();
}

void ResultsTable::write() {
  const std::vector<double> rows = std::exchange(waiting_, {});  // a write that fails is not tried again
  if (!rows.empty()) file_.write([&] { put_rows(rows); });
}

void ResultsTable::put_rows(const std::vector<double>& rows) {
  const hsize_t first = length_, count = rows.size() / width_;
  length_ += count;
  succeed(H5Dset_extent(dataset_, &length_), "extend a table");
  const Closing file_space(valid(H5Dget_space(dataset_), "extend a table"), H5Sclose);
  const Closing memory_space(valid(H5Screate_simple(1, &count, nullptr), "extend a table"), H5Sclose);
  if (file_.rank() == 0) {
    succeed(H5Sselect_hyperslab(file_space, H5S_SELECT_SET, &first, nullptr, &count, nullptr), "select rows");
  } else {
    succeed(H5Sselect_none(file_space), "select rows");
    succeed(H5Sselect_none(memory_space), "select rows");
  }
  succeed(H5Dwrite(dataset_, memory_type_, memory_space, file_space, H5P_DEFAULT, rows.data()), "write rows");
  succeed(H5Fflush(file_.hdf5_file(), H5F_SCOPE_GLOBAL), "flush a table");
}

void write_table(ResultsFile& file, const std::string& path, const std::vector<TableColumn>& columns,
                 const std::vector<double>& rows) {
  ResultsTable table(file, path, columns);
  table.append(rows);
  table.write();
}

}  // namespace gearfilm
