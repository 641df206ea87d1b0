#include "output/provenance.hpp"

#include <fftw3.h>
#include <hdf5.h>
#include <slepcsys.h>

#include <string>

#include "gearfilm/version.hpp"
#include "parallel/agreement.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {
namespace {

template <class Number>
std::string dotted(Number major, Number minor, Number patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string petsc_version(PetscErrorCode (*get)(PetscInt*, PetscInt*, PetscInt*, PetscInt*)) {
  PetscInt major = 0, minor = 0, patch = 0, release = 0;
  petsc_check(get(&major, &minor, &patch, &release));
  return dotted(major, minor, patch);
}

std::string hdf5_version() {
  unsigned major = 0, minor = 0, patch = 0;
  H5get_libversion(&major, &minor, &patch);
  return dotted(major, minor, patch);
}

/// "Open MPI v4.1.4" of a text that goes on with builder and date.
std::string mpi_version() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string whole(text, static_cast<std::size_t>(length));
  return whole.substr(0, whole.find_first_of(",\n"));
}

}  // namespace

Summary provenance(MPI_Comm comm) {
  return {{"version", version},
          {"processes", processes_in(comm)},
          {"petsc", petsc_version(PetscGetVersionNumber)},
          {"slepc", petsc_version(SlepcGetVersionNumber)},
          {"mpi", mpi_version()},
          {"hdf5", hdf5_version()},
          {"fftw", std::string(fftw_version)}};
}

}  // namespace gearfilm
