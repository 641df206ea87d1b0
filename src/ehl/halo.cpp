#include "gearfilm/ehl/halo.hpp"

namespace gearfilm {

Halo::Halo(const Grid& grid) : alone_(grid.processes() == 1), first_(grid.rank() == 0) {
  if (alone_) return;
  VecScatter to_local = nullptr;  // a PetscSF, from compact fields to local vectors
  petsc_check(DMDAGetScatter(grid.nodes(), &to_local, nullptr));
  PetscInt own_nodes = 0, nodes = 0;
  const PetscInt* places = nullptr;
  const PetscSFNode* origins = nullptr;
  petsc_check(PetscSFGetGraph(to_local, &own_nodes, &nodes, &places, &origins));
  std::vector<PetscInt> ghosts;
  std::vector<PetscSFNode> sources;
  for (PetscInt n = 0; n < nodes; ++n) {
    const PetscSFNode& origin = origins[n];
    if (origin.rank == grid.rank()) continue;
    const PetscInt rows = grid.y_ranges()[origin.rank + 1] - grid.y_ranges()[origin.rank];
    ghosts.push_back(places ? places[n] : n);
    // The neighbour's node in its Field, whose lines begin with a ghost.
    sources.push_back({origin.rank, origin.index / rows * (rows + 2) + origin.index % rows + 1});
  }
  petsc_check(PetscSFCreate(grid.comm(), forest_.put()));
  petsc_check(PetscSFSetGraph(forest_, static_cast<PetscInt>(grid.nx()) * (grid.y_count() + 2),
                              static_cast<PetscInt>(ghosts.size()), ghosts.data(), PETSC_COPY_VALUES, sources.data(),
                              PETSC_COPY_VALUES));
  petsc_check(PetscSFSetUp(forest_));
}

}  // namespace gearfilm
