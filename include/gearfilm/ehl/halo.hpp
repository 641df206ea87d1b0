// Exchange of the ghost rows of a Field between neighbouring processes, and their mirror image across Y = 0.
#pragma once

#include <array>
#include <map>
#include <span>
#include <type_traits>
#include <utility>

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
  ~Halo();
  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  /// Fills the ghosts of all these fields, with one message to a neighbour.
  template <class Real, class... More>
  void exchange(Field<Real>& first, More&... more) const {
    const std::array<Field<Real>*, 1 + sizeof...(More)> fields{&first, &more...};
    if (!alone_) travel<Real>(fields);
    if (first_) reflect<Real>(fields);
  }

private:
  template <class Real>
  void travel(std::span<Field<Real>* const> fields) const;
  /// A value of each of so many fields.
  MPI_Datatype values_of(std::size_t fields, MPI_Datatype real) const;

  template <class Real>
  static void reflect(std::span<Field<Real>* const> fields) {
    for (Field<Real>* field : fields) {
      for (int i = 0; i < field->nx(); ++i) field->row(i)[-1] = field->row(i)[1];
    }
  }

  OwnedSF forest_;  ///< roots: own edge rows; leaves: the neighbours' ghost rows; [line][south, north]
  bool alone_;
  bool first_;  ///< holds row 0
  bool last_;   ///< holds the last row
  mutable std::map<std::pair<std::size_t, MPI_Datatype>, MPI_Datatype> types_;
};

}  // namespace gearfilm
