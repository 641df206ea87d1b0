#include "gearfilm/io/results_file.hpp"

#include <fstream>

#include "gearfilm/error.hpp"
#include "gearfilm/io/output_directory.hpp"

namespace gearfilm {

ResultsFile::ResultsFile(MPI_Comm comm, std::filesystem::path path) : comm_(comm), path_(std::move(path)) {
  petsc_check(PetscViewerHDF5Open(comm, part_of(path_).c_str(), FILE_MODE_WRITE, viewer_.put()));
}

void ResultsFile::attribute(const std::string& group, const std::string& name, const std::string& value) {
  petsc_check(PetscViewerHDF5WriteGroup(viewer_, group.c_str()));
  petsc_check(PetscViewerHDF5WriteAttribute(viewer_, group.c_str(), name.c_str(), PETSC_STRING, value.c_str()));
}

void ResultsFile::attribute(const std::string& group, const std::string& name, double value) {
  petsc_check(PetscViewerHDF5WriteGroup(viewer_, group.c_str()));
  petsc_check(PetscViewerHDF5WriteAttribute(viewer_, group.c_str(), name.c_str(), PETSC_DOUBLE, &value));
}

void ResultsFile::view(const std::string& group, const std::string& name, Vec vec, const std::string& unit) {
  petsc_check(PetscViewerHDF5PushGroup(viewer_, group.c_str()));
  petsc_check(PetscObjectSetName(reinterpret_cast<PetscObject>(vec), name.c_str()));
  petsc_check(VecView(vec, viewer_));
  petsc_check(PetscViewerHDF5PopGroup(viewer_));
  const std::string dataset = group + "/" + name;
  petsc_check(PetscViewerHDF5WriteAttribute(viewer_, dataset.c_str(), "unit", PETSC_STRING, unit.c_str()));
}

void ResultsFile::field(const std::string& group, const std::string& name, const std::string& unit, const Grid& grid,
                        const Field<double>& values, double scale) {
  const OwnedVec vec = grid.create_vec();
  values.store(static_cast<double*>(VecWriting(vec)));
  petsc_check(VecScale(vec, scale));
  view(group, name, vec, unit);
}

void ResultsFile::line(const std::string& group, const std::string& name, const std::vector<double>& values) {
  int rank = 0;
  MPI_Comm_rank(comm_, &rank);
  const PetscInt count = static_cast<PetscInt>(values.size());
  OwnedVec vec;
  petsc_check(VecCreateMPI(comm_, rank == 0 ? count : 0, count, vec.put()));
  if (rank == 0) std::copy(values.begin(), values.end(), static_cast<double*>(VecWriting(vec)));
  view(group, name, vec, "m");
}

void ResultsFile::grid(const std::string& group, const Grid& grid, const Scales& scales) {
  std::vector<double> x(grid.nx()), y(grid.ny());
  for (int i = 0; i < grid.nx(); ++i) x[i] = scales.length * grid.x(i);
  for (int j = 0; j < grid.ny(); ++j) y[j] = scales.length * grid.y(j - grid.y_begin());
  line(group, "x", x);
  line(group, "y", y);
  OwnedDM pairs;
  OwnedVec mesh;
  petsc_check(DMDACreateCompatibleDMDA(grid.dm(), 2, pairs.put()));
  petsc_check(DMCreateGlobalVector(pairs, mesh.put()));
  {
    const VecWriting values(mesh);
    double* next = values;
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        *next++ = x[i];
        *next++ = y[grid.y_begin() + j];
      }
    }
  }
  view(group, "mesh", mesh, "m");
}

void ResultsFile::finish() {
  viewer_.reset();
  finish_part(comm_, path_);
}

void write_xdmf(const std::filesystem::path& path, const std::string& results_name, const std::string& group,
                const Grid& grid) {
  if (grid.rank() == 0) {
    const std::string size = std::to_string(grid.nx()) + " " + std::to_string(grid.ny());
    std::ofstream file(part_of(path));
    file << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n  <Domain>\n    <Grid Name=\"" << group.substr(1)
         << "\" GridType=\"Uniform\">\n      <Topology TopologyType=\"2DSMesh\" Dimensions=\"" << size
         << "\"/>\n      <Geometry GeometryType=\"XY\">\n        <DataItem Format=\"HDF\" NumberType=\"Float\" "
            "Precision=\"8\" Dimensions=\""
         << size << " 2\">" << results_name << ":" << group << "/mesh</DataItem>\n      </Geometry>\n";
    for (const char* name : {"P", "H"}) {
      file << "      <Attribute Name=\"" << name << "\" AttributeType=\"Scalar\" Center=\"Node\">\n"
           << "        <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"" << size << "\">"
           << results_name << ":" << group << "/" << name << "</DataItem>\n      </Attribute>\n";
    }
    file << "    </Grid>\n  </Domain>\n</Xdmf>\n";
  }
  finish_part(grid.comm(), path);
}

}  // namespace gearfilm
