// Exchange of the ghost rows of a Field between neighbouring processes.
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

/// Serves all fields of one grid, in either precision. On one process it does nothing.
class Halo {
public:
  explicit Halo(const Grid& grid);

  template <class Real>
  void exchange(Field<Real>& field) const {
    if (alone_) return;
    petsc_check(PetscSFBcastBegin(forest_, mpi_type<Real>(), field.data(), field.data(), MPI_REPLACE));
    petsc_check(PetscSFBcastEnd(forest_, mpi_type<Real>(), field.data(), field.data(), MPI_REPLACE));
  }

private:
  OwnedSF forest_;  ///< roots: own edge rows; leaves: the neighbours' ghost rows
  bool alone_;
};

}  // namespace gearfilm
