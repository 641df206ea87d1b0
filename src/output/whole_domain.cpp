#include "gearfilm/output/whole_domain.hpp"

#include <petscdmda.h>

#include <algorithm>
#include <cstdlib>

namespace gearfilm {

WholeDomain::WholeDomain(const Grid& grid)
    : grid_(grid), ranges_(cut_evenly(grid.ny(), grid.processes())), stored_(grid.create_vec()) {
  std::vector<PetscInt> counts(grid.processes());
  for (int p = 0; p < grid.processes(); ++p) counts[p] = ranges_[p + 1] - ranges_[p];
  const PetscInt all_x = grid.nx();
  petsc_check(DMDACreate2d(grid.comm(), DM_BOUNDARY_NONE, DM_BOUNDARY_NONE, DMDA_STENCIL_STAR, grid.ny(), grid.nx(),
                           grid.processes(), 1, 1, 1, counts.data(), &all_x, nodes_.put()));
  petsc_check(DMSetUp(nodes_));

  std::vector<PetscInt> sources;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int row = ranges_[grid.rank()]; row < ranges_[grid.rank() + 1]; ++row)
      sources.push_back(index_on_grid(i, row));
  }
  OwnedVec whole;
  petsc_check(DMCreateGlobalVector(nodes_, whole.put()));
  PetscInt first = 0;
  petsc_check(VecGetOwnershipRange(whole, &first, nullptr));
  PetscHandle<IS, ISDestroy> from, to;
  const auto size = static_cast<PetscInt>(sources.size());
  petsc_check(ISCreateGeneral(grid.comm(), size, sources.data(), PETSC_COPY_VALUES, from.put()));
  petsc_check(ISCreateStride(grid.comm(), size, first, 1, to.put()));
  petsc_check(VecScatterCreate(stored_, from, whole, to, scatter_.put()));
}

/// Where the grid's vectors have the value of a node of the whole domain.
PetscInt WholeDomain::index_on_grid(int i, int row) const {
  const std::span<const int> cuts = grid_.y_ranges();
  const int stored_row = std::abs(from_middle(row));
  const auto owner = std::upper_bound(cuts.begin(), cuts.end(), stored_row) - 1;
  const int begin = owner[0], count = owner[1] - owner[0];
  return static_cast<PetscInt>(grid_.nx()) * begin + i * count + stored_row - begin;
}

OwnedVec WholeDomain::unfold(const Field<double>& values, double scale) const {
  values.store(VecWriting(stored_).values());
  OwnedVec whole;
  petsc_check(DMCreateGlobalVector(nodes_, whole.put()));
  petsc_check(VecScatterBegin(scatter_, stored_, whole, INSERT_VALUES, SCATTER_FORWARD));
  petsc_check(VecScatterEnd(scatter_, stored_, whole, INSERT_VALUES, SCATTER_FORWARD));
  petsc_check(VecScale(whole, scale));
  return whole;
}

OwnedVec WholeDomain::coordinates(double scale) const {
  OwnedDM pairs;
  OwnedVec mesh;
  petsc_check(DMDACreateCompatibleDMDA(nodes_, 2, pairs.put()));
  petsc_check(DMCreateGlobalVector(pairs, mesh.put()));
  const VecWriting values(mesh);
  std::size_t next = 0;
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int row = ranges_[grid_.rank()]; row < ranges_[grid_.rank() + 1]; ++row) {
      values[next++] = scale * grid_.x(i);
      values[next++] = scale * y(row);
    }
  }
  return mesh;
}

}  // namespace gearfilm
