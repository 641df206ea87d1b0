#include "gearfilm/output/results_file.hpp"

#include <hdf5_hl.h>

#include <sstream>

#include "gearfilm/error.hpp"
#include "gearfilm/output/hdf5_handle.hpp"
#include "gearfilm/output/output_directory.hpp"

namespace gearfilm {
namespace {

/// An axis keeps a list of its fields in an attribute, which HDF5 bounds by 64 kB of 16 bytes a field.
constexpr int most_fields_of_an_axis = 4000;

void put_text(hid_t file, const std::string& object, const std::string& name, const std::string& value) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "create a text type");
  hdf5_check(H5Tset_size(type, H5T_VARIABLE), "create a text type");
  hdf5_check(H5Tset_cset(type, H5T_CSET_UTF8), "create a text type");
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create an attribute");
  const Hdf5Handle attribute(
      H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, "create an attribute");
  const char* text = value.c_str();
  hdf5_check(H5Awrite(attribute, type, &text), "write an attribute");
}

}  // namespace

ResultsFile::ResultsFile(MPI_Comm comm, std::filesystem::path path) : comm_(comm), path_(std::move(path)) {
  MPI_Comm_rank(comm, &rank_);
  write([&] { petsc_check(PetscViewerHDF5Open(comm, part_of(path_).c_str(), FILE_MODE_WRITE, viewer_.put())); });
}

// Closing takes all processes, but an error may have struck this one alone; and HDF5 cannot close what it could not
// write. Without finish() the file is left to the end of the program.
ResultsFile::~ResultsFile() { (void)viewer_.release(); }

hid_t ResultsFile::hdf5_file() {
  hid_t file = H5I_INVALID_HID;
  petsc_check(PetscViewerHDF5GetFileId(viewer_, &file));
  return file;
}

void ResultsFile::attribute(const std::string& group, const std::string& name, const std::string& value) {
  write([&] {
    petsc_check(PetscViewerHDF5WriteGroup(viewer_, group.c_str()));
    put_text(hdf5_file(), group, name, value);
  });
}

void ResultsFile::attribute(const std::string& group, const std::string& name, double value) {
  write([&] {
    petsc_check(PetscViewerHDF5WriteGroup(viewer_, group.c_str()));
    petsc_check(PetscViewerHDF5WriteAttribute(viewer_, group.c_str(), name.c_str(), PETSC_DOUBLE, &value));
  });
}

void ResultsFile::attribute(const std::string& group, const std::string& name, int value) {
  const PetscInt number = value;
  write([&] {
    petsc_check(PetscViewerHDF5WriteGroup(viewer_, group.c_str()));
    petsc_check(PetscViewerHDF5WriteAttribute(viewer_, group.c_str(), name.c_str(), PETSC_INT, &number));
  });
}

void ResultsFile::dataset_attribute(const std::string& dataset, const std::string& name, const std::string& value) {
  write([&] { put_text(hdf5_file(), dataset, name, value); });
}

void ResultsFile::view(const std::string& group, const std::string& name, Vec vec, const std::string& unit) {
  write([&] {
    petsc_check(PetscViewerHDF5PushGroup(viewer_, group.c_str()));
    petsc_check(PetscObjectSetName(reinterpret_cast<PetscObject>(vec), name.c_str()));
    petsc_check(VecView(vec, viewer_));
    petsc_check(PetscViewerHDF5PopGroup(viewer_));
  });
  dataset_attribute(group + "/" + name, "unit", unit);
}

void ResultsFile::field(const std::string& group, const std::string& name, const std::string& unit,
                        const WholeDomain& domain, const Field<double>& values, double scale, const std::string& axes) {
  view(group, name, domain.unfold(values, scale), unit);
  int& fields = fields_of_[axes];
  if (++fields > most_fields_of_an_axis) return;
  write([&] {
    const Hdf5Handle dataset(H5Dopen2(hdf5_file(), (group + "/" + name).c_str(), H5P_DEFAULT), H5Dclose,
                             "open a field");
    unsigned dimension = 0;
    for (const char* axis : {"/x", "/y"}) {
      const Hdf5Handle scale_of(H5Dopen2(hdf5_file(), (axes + axis).c_str(), H5P_DEFAULT), H5Dclose, "open an axis");
      hdf5_check(H5DSattach_scale(dataset, scale_of, dimension++), "give a field its axis");
    }
  });
}

void ResultsFile::line(const std::string& group, const std::string& name, const std::vector<double>& values) {
  const auto count = static_cast<PetscInt>(values.size());
  OwnedVec vec;
  petsc_check(VecCreateMPI(comm_, rank_ == 0 ? count : 0, count, vec.put()));
  if (rank_ == 0) std::ranges::copy(values, VecWriting(vec).values().begin());
  view(group, name, vec, "m");
}

void ResultsFile::rows(const std::string& group, const std::string& name, const std::string& unit, int rows,
                       int columns, const std::vector<double>& values) {
  const PetscInt count = static_cast<PetscInt>(rows) * columns;
  OwnedVec vec;
  petsc_check(VecCreate(comm_, vec.put()));
  petsc_check(VecSetSizes(vec, rank_ == 0 ? count : 0, count));
  petsc_check(VecSetBlockSize(vec, columns));
  petsc_check(VecSetType(vec, VECSTANDARD));
  if (rank_ == 0) std::ranges::copy(values, VecWriting(vec).values().begin());
  view(group, name, vec, unit);
}

void ResultsFile::grid(const std::string& group, const WholeDomain& domain, const Scales& scales) {
  const Grid& grid = domain.grid();
  std::vector<double> x(grid.nx()), y(grid.ny());
  for (int i = 0; i < grid.nx(); ++i) x[i] = scales.length * grid.x(i);
  for (int j = 0; j < grid.ny(); ++j) y[j] = scales.length * domain.y(j);
  line(group, "x", x);
  line(group, "y", y);
  write([&] {
    for (const char* axis : {"x", "y"}) {
      const Hdf5Handle dataset(H5Dopen2(hdf5_file(), (group + "/" + axis).c_str(), H5P_DEFAULT), H5Dclose,
                               "open an axis");
      hdf5_check(H5DSset_scale(dataset, axis), "make an axis");
    }
  });
  view(group, "mesh", domain.coordinates(scales.length), "m");
}

void ResultsFile::publish() {
  write([&] {
    if (H5Fflush(hdf5_file(), H5F_SCOPE_GLOBAL) < 0) throw std::runtime_error("HDF5 cannot flush it");
  });
  take_name();
}

void ResultsFile::take_name() {
  finish_part(comm_, path_);
  published_ = true;
}

void ResultsFile::finish() {
  write([&] {
    PetscViewer viewer = viewer_.release();
    petsc_check(PetscViewerDestroy(&viewer));
  });
  if (!published_) take_name();
}

}  // namespace gearfilm
