#include "output/results_table.hpp"

#include <utility>

#include "output/hdf5_handle.hpp"

namespace gearfilm {
namespace {

constexpr hsize_t rows_per_chunk = 256;
constexpr double seconds_between_writes = 0.5;
constexpr std::size_t conversion_bytes = 65536;  // of HDF5, which keeps a buffer twice

}  // namespace

ResultsTable::ResultsTable(ResultsFile& file, const std::string& path, const std::vector<TableColumn>& columns)
    : file_(file), width_(columns.size()) {
  std::string units;
  for (const TableColumn& column : columns) units += column.name + " " + column.unit + "\n";
  file_.write([&] { create(path, columns); });
  file_.dataset_attribute(path, "units", units);
}

void ResultsTable::create(const std::string& path, const std::vector<TableColumn>& columns) {
  memory_type_ = hdf5_valid(H5Tcreate(H5T_COMPOUND, width_ * sizeof(double)), "create a table type");
  std::size_t file_width = 0;
  for (const TableColumn& column : columns) file_width += column.integer ? sizeof(int) : sizeof(double);
  const Hdf5Handle file_type(H5Tcreate(H5T_COMPOUND, file_width), H5Tclose, "create a table type");
  std::size_t file_offset = 0;
  for (std::size_t n = 0; n < width_; ++n) {
    const TableColumn& column = columns[n];
    hdf5_check(H5Tinsert(memory_type_, column.name.c_str(), n * sizeof(double), H5T_NATIVE_DOUBLE), "add a column");
    const hid_t type = column.integer ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE;
    hdf5_check(H5Tinsert(file_type, column.name.c_str(), file_offset, type), "add a column");
    file_offset += H5Tget_size(type);
  }
  const hsize_t empty = 0, unlimited = H5S_UNLIMITED, chunk = rows_per_chunk;
  const Hdf5Handle space(H5Screate_simple(1, &empty, &unlimited), H5Sclose, "create a table");
  const Hdf5Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "create a table");
  hdf5_check(H5Pset_chunk(layout, 1, &chunk), "create a table");
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "create a table");
  hdf5_check(H5Pset_create_intermediate_group(links, 1), "create a table");
  dataset_ = hdf5_valid(H5Dcreate2(file_.hdf5_file(), path.c_str(), file_type, space, links, layout, H5P_DEFAULT),
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
  hdf5_check(H5Dset_extent(dataset_, &length_), "extend a table");
  const Hdf5Handle file_space(H5Dget_space(dataset_), H5Sclose, "extend a table");
  const Hdf5Handle memory_space(H5Screate_simple(1, &count, nullptr), H5Sclose, "extend a table");
  if (file_.rank() == 0) {
    hdf5_check(H5Sselect_hyperslab(file_space, H5S_SELECT_SET, &first, nullptr, &count, nullptr), "select rows");
  } else {
    hdf5_check(H5Sselect_none(file_space), "select rows");
    hdf5_check(H5Sselect_none(memory_space), "select rows");
  }
  const Hdf5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "write rows");
  hdf5_check(H5Pset_buffer(transfer, conversion_bytes, nullptr, nullptr), "write rows");
  hdf5_check(H5Dwrite(dataset_, memory_type_, memory_space, file_space, transfer, rows.data()), "write rows");
  hdf5_check(H5Fflush(file_.hdf5_file(), H5F_SCOPE_GLOBAL), "flush a table");
}

void write_table(ResultsFile& file, const std::string& path, const std::vector<TableColumn>& columns,
                 const std::vector<double>& rows) {
  ResultsTable table(file, path, columns);
  table.append(rows);
  table.write();
}

}  // namespace gearfilm
