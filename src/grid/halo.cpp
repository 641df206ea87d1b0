#include "grid/halo.hpp"

namespace gearfilm {

Halo::Halo(const Grid& grid) : comm_(grid.comm()), mirror_row_(grid.mirror_row()) {
  if (grid.rank() > 0) neighbours_.push_back({grid.rank() - 1, 0, -1});
  if (grid.rank() + 1 < grid.processes()) {
    neighbours_.push_back({grid.rank() + 1, grid.y_count() - 1, grid.y_count()});
  }
}

template <class Real>
void Halo::travel(std::span<Field<Real>* const> fields) const {
  constexpr int tag = 0;
  const int lines = fields.front()->nx();
  const int size = lines * static_cast<int>(fields.size());
  std::array<MPI_Request, 4> requests{};
  std::vector<Real> edges(size * neighbours_.size()), ghosts(edges.size());
  MPI_Request* request = requests.data();
  const auto part_of = [&](std::vector<Real>& values, std::size_t neighbour) {
    return values.data() + neighbour * static_cast<std::size_t>(size);
  };
  for (std::size_t n = 0; n < neighbours_.size(); ++n) {
    MPI_Irecv(part_of(ghosts, n), size, mpi_type<Real>(), neighbours_[n].rank, tag, comm_, request++);
  }
  for (std::size_t n = 0; n < neighbours_.size(); ++n) {
    Real* value = part_of(edges, n);
    for (const Field<Real>* field : fields) {
      for (int i = 0; i < lines; ++i) *value++ = field->row(i)[neighbours_[n].edge];
    }
    MPI_Isend(part_of(edges, n), size, mpi_type<Real>(), neighbours_[n].rank, tag, comm_, request++);
  }
  MPI_Waitall(static_cast<int>(request - requests.data()), requests.data(), MPI_STATUSES_IGNORE);
  for (std::size_t n = 0; n < neighbours_.size(); ++n) {
    const Real* value = part_of(ghosts, n);
    for (Field<Real>* field : fields) {
      for (int i = 0; i < lines; ++i) field->row(i)[neighbours_[n].ghost] = *value++;
    }
  }
}

template void Halo::travel(std::span<Field<float>* const>) const;
template void Halo::travel(std::span<Field<double>* const>) const;
template void Halo::travel(std::span<Field<std::complex<double>>* const>) const;

}  // namespace gearfilm
