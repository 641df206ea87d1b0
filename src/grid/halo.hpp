// Exchange of the ghost rows of a Field between neighbouring processes, and their mirror image in a row of symmetry.
#pragma once

#include <array>
#include <complex>
#include <span>
#include <type_traits>
#include <vector>

#include "grid/field.hpp"

namespace gearfilm {

/// MPI's name of a type of values.
template <class Real>
MPI_Datatype mpi_type() {
  if constexpr (std::is_same_v<Real, std::complex<double>>) {
    return MPI_C_DOUBLE_COMPLEX;
  } else {
    static_assert(std::is_same_v<Real, float> || std::is_same_v<Real, double>);
    return std::is_same_v<Real, float> ? MPI_FLOAT : MPI_DOUBLE;
  }
}

/// Serves all fields of one grid, in either precision, complex ones too: each process has the rows between those of its
/// neighbours.
class Halo {
public:
  explicit Halo(const Grid& grid);

  /// Fills the ghosts of all these fields, with one message to a neighbour.
  template <class Real, class... More>
  void exchange(Field<Real>& first, More&... more) const {
    const std::array<Field<Real>*, 1 + sizeof...(More)> fields{&first, &more...};
    if (!neighbours_.empty()) travel<Real>(fields);
    if (mirror_row_ >= 0) reflect<Real>(fields);
  }

private:
  struct Neighbour {
    int rank;
    int edge;   ///< own row next to it
    int ghost;  ///< its row next to that
  };

  template <class Real>
  void travel(std::span<Field<Real>* const> fields) const;

  template <class Real>
  void reflect(std::span<Field<Real>* const> fields) const {
    for (Field<Real>* field : fields) {
      for (int i = 0; i < field->nx(); ++i) field->row(i)[mirror_row_ - 1] = field->row(i)[mirror_row_ + 1];
    }
  }

  MPI_Comm comm_;
  int mirror_row_;  ///< of this process, or -1
  std::vector<Neighbour> neighbours_;
};

}  // namespace gearfilm
