#include "gearfilm/ehl/halo.hpp"

#include <vector>

namespace gearfilm {

Halo::Halo(const Grid& grid)
    : alone_(grid.processes() == 1), first_(grid.rank() == 0), last_(grid.rank() == grid.processes() - 1) {
  if (alone_) return;
  VecScatter to_local = nullptr;  // a PetscSF, from compact fields to local vectors
  petsc_check(DMDAGetScatter(grid.nodes(), &to_local, nullptr));
  PetscInt own_nodes = 0, nodes = 0;
  const PetscInt* places = nullptr;
  const PetscSFNode* origins = nullptr;
  petsc_check(PetscSFGetGraph(to_local, &own_nodes, &nodes, &places, &origins));
  // Edge nodes as [line][south, north].
  const auto edge = [](PetscInt line, bool south) { return 2 * line + (south ? 0 : 1); };
  const PetscInt stride = grid.y_count() + 2;
  std::vector<PetscInt> ghosts;
  std::vector<PetscSFNode> sources;
  for (PetscInt n = 0; n < nodes; ++n) {
    const PetscSFNode& origin = origins[n];
    if (origin.rank == grid.rank()) continue;
    const PetscInt rows = grid.y_ranges()[origin.rank + 1] - grid.y_ranges()[origin.rank];
    const PetscInt place = places ? places[n] : n;
    ghosts.push_back(edge(place / stride, place % stride == 0));
    sources.push_back({origin.rank, edge(origin.index / rows, origin.index % rows == 0)});
  }
  petsc_check(PetscSFCreate(grid.comm(), forest_.put()));
  petsc_check(PetscSFSetGraph(forest_, 2 * static_cast<PetscInt>(grid.nx()), static_cast<PetscInt>(ghosts.size()),
                              ghosts.data(), PETSC_COPY_VALUES, sources.data(), PETSC_COPY_VALUES));
  petsc_check(PetscSFSetUp(forest_));
}

Halo::~Halo() {
  for (auto& [key, type] : types_) MPI_Type_free(&type);
}

MPI_Datatype Halo::values_of(std::size_t fields, MPI_Datatype real) const {
  if (fields == 1) return real;
  const auto [entry, is_new] = types_.try_emplace({fields, real}, MPI_DATATYPE_NULL);
  if (is_new) {
    MPI_Type_contiguous(static_cast<int>(fields), real, &entry->second);
    MPI_Type_commit(&entry->second);
  }
  return entry->second;
}

template <class Real>
void Halo::travel(std::span<Field<Real>* const> fields) const {
  const std::size_t count = fields.size();
  const int lines = fields.front()->nx(), north = fields.front()->y_count();
  std::vector<Real> edges(2 * lines * count), ghosts(edges.size());
  for (int i = 0; i < lines; ++i) {
    Real* values = edges.data() + 2 * i * count;
    for (std::size_t f = 0; f < count; ++f) {
      values[f] = fields[f]->row(i)[0];
      values[count + f] = fields[f]->row(i)[north - 1];
    }
  }
  MPI_Datatype type = values_of(count, mpi_type<Real>());
  petsc_check(PetscSFBcastBegin(forest_, type, edges.data(), ghosts.data(), MPI_REPLACE));
  petsc_check(PetscSFBcastEnd(forest_, type, edges.data(), ghosts.data(), MPI_REPLACE));
  for (int i = 0; i < lines; ++i) {
    const Real* values = ghosts.data() + 2 * i * count;
    for (std::size_t f = 0; f < count; ++f) {
      if (!first_) fields[f]->row(i)[-1] = values[f];
      if (!last_) fields[f]->row(i)[north] = values[count + f];
    }
  }
}

template void Halo::travel(std::span<Field<float>* const>) const;
template void Halo::travel(std::span<Field<double>* const>) const;

}  // namespace gearfilm
