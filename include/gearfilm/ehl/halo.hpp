// Exchange of the ghost rows of a Field between neighbouring processes, and their mirror image across Y = 0.
#pragma once

#include <type_traits>

#include "gearfilm/ehl/field.hpp"

namespace gearfilm {

/// MPI's name of an arithmetic type.
template <class Real>
MPI_Datatype mpi_type() {
  static_assert(std::is_same_v<Real, float> || std::is_same_v<Real, double>);
  return std::is_same_v<Real, float> ? MPI_FLOAT : MPI_DOUBLE;
}

/// Serves all fields of one grid, in either precision. Which ghost is whose row is the DMDA's; PETSc's own update of
/// local vectors copies the own nodes too.
class Halo {
public:
  explicit Halo(const Grid& grid);

  /// Fills the ghosts of all these fields; their messages travel together.
  template <class... Fields>
  void exchange(Fields&... fields) const {
    if (!alone_) {
      (begin(fields), ...);
      (end(fields), ...);
    }
    if (first_) (reflect(fields), ...);
  }

private:
  template <class Real>
  void begin(Field<Real>& field) const {
    petsc_check(PetscSFBcastBegin(forest_, mpi_type<Real>(), field.data(), field.data(), MPI_REPLACE));
  }
  template <class Real>
  void end(Field<Real>& field) const {
    petsc_check(PetscSFBcastEnd(forest_, mpi_type<Real>(), field.data(), field.data(), MPI_REPLACE));
  }

  template <class Real>
  static void reflect(Field<Real>& field) {
    for (int i = 0; i < field.nx(); ++i) field.row(i)[-1] = field.row(i)[1];
  }

  OwnedSF forest_;  ///< roots: own edge rows; leaves: the neighbours' ghost rows
  bool alone_;
  bool first_;  ///< holds row 0
};

}  // namespace gearfilm
