#include "gearfilm/ehl/halo.hpp"

namespace gearfilm {

Halo::Halo(const Grid& grid) : alone_(grid.processes() == 1), first_(grid.rank() == 0) {
  if (alone_) return;
  const auto stride_of = [&](int process) { return grid.y_ranges()[process + 1] - grid.y_ranges()[process] + 2; };
  const int stride = stride_of(grid.rank());
  std::vector<PetscInt> ghosts;
  std::vector<PetscSFNode> sources;
  // Position 0 of a line is its lower ghost, stride-1 its upper one.
  const auto connect = [&](int neighbour, int ghost, int source) {
    for (int i = 0; i < grid.nx(); ++i) {
      ghosts.push_back(i * stride + ghost);
      sources.push_back({neighbour, i * stride_of(neighbour) + source});
    }
  };
  if (grid.rank() > 0) connect(grid.rank() - 1, 0, stride_of(grid.rank() - 1) - 2);
  if (grid.rank() < grid.processes() - 1) connect(grid.rank() + 1, stride - 1, 1);
  petsc_check(PetscSFCreate(grid.comm(), forest_.put()));
  petsc_check(PetscSFSetGraph(forest_, static_cast<PetscInt>(grid.nx()) * stride, static_cast<PetscInt>(ghosts.size()),
                              ghosts.data(), PETSC_COPY_VALUES, sources.data(), PETSC_COPY_VALUES));
  petsc_check(PetscSFSetUp(forest_));
}

}  // namespace gearfilm
