#include "grid/node_scatter.hpp"

namespace gearfilm {

NodeScatter::NodeScatter(const Grid& grid, std::span<const PetscInt> sources) {
  const OwnedVec vec = grid.create_vec();
  PetscLayout layout = nullptr;
  petsc_check(VecGetLayout(vec, &layout));
  petsc_check(PetscSFCreate(grid.comm(), scatter_.put()));
  petsc_check(PetscSFSetGraphLayout(scatter_, layout, static_cast<PetscInt>(sources.size()), nullptr, PETSC_COPY_VALUES,
                                    sources.data()));
}

void NodeScatter::operator()(std::span<const double> field, std::span<double> wanted) const {
  petsc_check(PetscSFBcastBegin(scatter_, MPIU_SCALAR, field.data(), wanted.data(), MPI_REPLACE));
  petsc_check(PetscSFBcastEnd(scatter_, MPIU_SCALAR, field.data(), wanted.data(), MPI_REPLACE));
}

}  // namespace gearfilm
