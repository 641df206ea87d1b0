#include "output/results_file.hpp"

#include <hdf5_hl.h>

#include "gearfilm/error.hpp"
#include "output/hdf5_handle.hpp"
#include "output/output_directory.hpp"

namespace gearfilm {
namespace {

/// An axis keeps a list of its fields in an attribute, which HDF5 bounds by 64 kB of 16 bytes a field.
constexpr int most_fields_of_an_axis = 4000;

/// Changed metadata [bytes] beyond which HDF5 has all processes meet to write them; the most that it accepts. It may
/// notice not in the call of all that made the change, but in the next one: rows of a table are written by the first
/// process alone, which would wait there for ever. Tables are flushed long before that.
constexpr std::size_t most_changed_metadata = 32 << 20;

void keep_metadata_until_flushed(hid_t access) {
  H5AC_cache_config_t cache = {};
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  hdf5_check(H5Pget_mdc_config(access, &cache), "tell how it keeps metadata");
  cache.dirty_bytes_threshold = most_changed_metadata;
  hdf5_check(H5Pset_mdc_config(access, &cache), "keep metadata");
}

hid_t create_file(MPI_Comm comm, const std::filesystem::path& path) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "create a file");
  hdf5_check(H5Pset_fapl_mpio(access, comm, MPI_INFO_NULL), "write by all processes");
  keep_metadata_until_flushed(access);
  return hdf5_valid(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), "create it");
}

/// A group, and those on the way to it, where they are missing.
void require_group(hid_t file, const std::string& path) {
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    const std::string part = path.substr(0, end);
    if (part != "/" && H5Lexists(file, part.c_str(), H5P_DEFAULT) <= 0) {
      const Hdf5Handle made(H5Gcreate2(file, part.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                            "create a group");
    }
    if (end == std::string::npos) return;
  }
}

void put_attribute(hid_t file, const std::string& object, const std::string& name, hid_t type, const void* value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create an attribute");
  const Hdf5Handle attribute(
      H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, "create an attribute");
  hdf5_check(H5Awrite(attribute, type, value), "write an attribute");
}

void put_text(hid_t file, const std::string& object, const std::string& name, const std::string& value) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "create a text type");
  hdf5_check(H5Tset_size(type, H5T_VARIABLE), "create a text type");
  hdf5_check(H5Tset_cset(type, H5T_CSET_UTF8), "create a text type");
  const char* text = value.c_str();
  put_attribute(file, object, name, type, &text);
}

}  // namespace

ResultsFile::ResultsFile(MPI_Comm comm, std::filesystem::path path)
    : comm_(comm), rank_(rank_in(comm)), path_(std::move(path)) {
  write([&] { file_ = create_file(comm, part_of(path_)); });
}

void ResultsFile::attribute(const std::string& group, const std::string& name, const std::string& value) {
  write([&] {
    require_group(file_, group);
    put_text(file_, group, name, value);
  });
}

void ResultsFile::attribute(const std::string& group, const std::string& name, double value) {
  write([&] {
    require_group(file_, group);
    put_attribute(file_, group, name, H5T_NATIVE_DOUBLE, &value);
  });
}

void ResultsFile::attribute(const std::string& group, const std::string& name, int value) {
  write([&] {
    require_group(file_, group);
    put_attribute(file_, group, name, H5T_NATIVE_INT, &value);
  });
}

void ResultsFile::dataset_attribute(const std::string& dataset, const std::string& name, const std::string& value) {
  write([&] { put_text(file_, dataset, name, value); });
}

// PETSc's viewer would wait for the disk after every one.
void ResultsFile::put(const std::string& group, const std::string& name, const DistributedArray& array,
                      const std::string& unit) {
  const std::string path = group + "/" + name;
  write([&] {
    require_group(file_, group);
    const int dimensions = static_cast<int>(array.all.size());
    const Hdf5Handle together(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "create an array");
    hdf5_check(H5Pset_dxpl_mpio(together, H5FD_MPIO_COLLECTIVE), "write by all processes");
    const Hdf5Handle all(H5Screate_simple(dimensions, array.all.data(), nullptr), H5Sclose, "create an array");
    const Hdf5Handle own(H5Screate_simple(dimensions, array.count.data(), nullptr), H5Sclose, "create an array");
    hdf5_check(H5Sselect_hyperslab(all, H5S_SELECT_SET, array.begin.data(), nullptr, array.count.data(), nullptr),
               "select a part");
    const Hdf5Handle dataset(
        H5Dcreate2(file_, path.c_str(), H5T_NATIVE_DOUBLE, all, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
        "create an array");
    hdf5_check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, own, all, together, array.values.data()), "write an array");
    put_text(file_, path, "unit", unit);
  });
}

void ResultsFile::put_by_first(const std::string& group, const std::string& name, const std::vector<hsize_t>& all,
                               const std::vector<double>& values, const std::string& unit) {
  const std::vector<hsize_t> nothing(all.size(), 0);
  const std::vector<hsize_t>& count = rank_ == 0 ? all : nothing;
  put(group, name, {all, nothing, count, rank_ == 0 ? values : std::vector<double>()}, unit);
}

void ResultsFile::field(const std::string& group, const std::string& name, const std::string& unit,
                        const WholeDomain& domain, const Field<double>& values, double scale, const std::string& axes) {
  put(group, name, domain.unfold(values, scale), unit);
  int& fields = fields_of_[axes];
  if (++fields > most_fields_of_an_axis) return;
  write([&] {
    const Hdf5Handle dataset(H5Dopen2(file_, (group + "/" + name).c_str(), H5P_DEFAULT), H5Dclose, "open a field");
    unsigned dimension = 0;
    for (const char* axis : {"/x", "/y"}) {
      const Hdf5Handle scale_of(H5Dopen2(file_, (axes + axis).c_str(), H5P_DEFAULT), H5Dclose, "open an axis");
      hdf5_check(H5DSattach_scale(dataset, scale_of, dimension++), "give a field its axis");
    }
  });
}

void ResultsFile::rows(const std::string& group, const std::string& name, const std::string& unit, int rows,
                       int columns, const std::vector<double>& values) {
  put_by_first(group, name, {static_cast<hsize_t>(rows), static_cast<hsize_t>(columns)}, values, unit);
}

void ResultsFile::blocks(const std::string& group, const std::string& name, const std::string& unit,
                         const std::array<int, 3>& size, const std::vector<double>& values) {
  put_by_first(group, name, {size.begin(), size.end()}, values, unit);
}

void ResultsFile::grid(const std::string& group, const WholeDomain& domain, const Scales& scales) {
  const Grid& grid = domain.grid();
  std::vector<double> x(grid.nx()), y(grid.ny());
  for (int i = 0; i < grid.nx(); ++i) x[i] = scales.length * grid.x(i);
  for (int j = 0; j < grid.ny(); ++j) y[j] = scales.length * domain.y(j);
  put_by_first(group, "x", {x.size()}, x, "m");
  put_by_first(group, "y", {y.size()}, y, "m");
  write([&] {
    for (const char* axis : {"x", "y"}) {
      const Hdf5Handle dataset(H5Dopen2(file_, (group + "/" + axis).c_str(), H5P_DEFAULT), H5Dclose, "open an axis");
      hdf5_check(H5DSset_scale(dataset, axis), "make an axis");
    }
  });
  put(group, "mesh", domain.coordinates(scales.length), "m");
}

void ResultsFile::publish() {
  write([&] { hdf5_check(H5Fflush(file_, H5F_SCOPE_GLOBAL), "flush it"); });
  take_name();
}

void ResultsFile::take_name() {
  finish_part(comm_, path_);
  published_ = true;
}

void ResultsFile::finish() {
  write([&] { hdf5_check(H5Fclose(file_), "close it"); });
  if (!published_) take_name();
}

}  // namespace gearfilm
