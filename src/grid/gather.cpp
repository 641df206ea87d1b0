#include "grid/gather.hpp"

#include <petscdmda.h>
#include <petscsf.h>

#include <algorithm>

namespace gearfilm {

Gather::Gather(const Grid& grid) : grid_(grid) {
  petsc_check(DMDAGlobalToNaturalAllCreate(grid.nodes(), to_natural_.put()));
}

// A VecScatter is a PetscSF, which moves plain arrays.
void Gather::to_all(std::span<const double> own, std::span<double> whole) const {
  petsc_check(PetscSFBcastBegin(to_natural_, MPIU_SCALAR, own.data(), whole.data(), MPI_REPLACE));
  petsc_check(PetscSFBcastEnd(to_natural_, MPIU_SCALAR, own.data(), whole.data(), MPI_REPLACE));
}

void Gather::own_part(std::span<const double> whole, std::span<double> own) const {
  for (int i = 0; i < grid_.nx(); ++i) {
    std::copy_n(whole.data() + static_cast<std::size_t>(i) * grid_.rows() + grid_.y_begin(), grid_.y_count(),
                own.data() + static_cast<std::size_t>(i) * grid_.y_count());
  }
}

}  // namespace gearfilm
