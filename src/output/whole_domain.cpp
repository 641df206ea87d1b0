#include "output/whole_domain.hpp"

#include <algorithm>

namespace gearfilm {

WholeDomain::WholeDomain(const Grid& grid)
    : grid_(grid), cuts_(cut_evenly(grid.ny(), grid.processes())), stored_(grid.create_vec()) {
  std::vector<PetscInt> sources;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int row = first_row(); row < end_row(); ++row) sources.push_back(index_on_grid(i, row));
  }
  const auto size = static_cast<PetscInt>(sources.size());
  petsc_check(VecCreateMPI(grid.comm(), size, PETSC_DETERMINE, whole_.put()));
  PetscInt first = 0;
  petsc_check(VecGetOwnershipRange(whole_, &first, nullptr));
  PetscHandle<IS, ISDestroy> from, to;
  petsc_check(ISCreateGeneral(grid.comm(), size, sources.data(), PETSC_COPY_VALUES, from.put()));
  petsc_check(ISCreateStride(grid.comm(), size, first, 1, to.put()));
  petsc_check(VecScatterCreate(stored_, from, whole_, to, scatter_.put()));
}

/// Where the grid's vectors have the value of a node of the whole domain.
PetscInt WholeDomain::index_on_grid(int i, int row) const {
  const std::span<const int> cuts = grid_.y_ranges();
  const int stored_row = grid_.row_axis().stored_row(row);
  const auto owner = std::upper_bound(cuts.begin(), cuts.end(), stored_row) - 1;
  const int begin = owner[0], count = owner[1] - owner[0];
  return static_cast<PetscInt>(grid_.nx()) * begin + i * count + stored_row - begin;
}

DistributedArray WholeDomain::extents() const {
  const auto lines = static_cast<hsize_t>(grid_.nx()), rows = static_cast<hsize_t>(grid_.ny());
  const auto first = static_cast<hsize_t>(first_row()), end = static_cast<hsize_t>(end_row());
  return {{lines, rows}, {0, first}, {lines, end - first}, {}};
}

DistributedArray WholeDomain::unfold(const Field<double>& values, double scale) const {
  values.store(VecWriting(stored_).values());
  petsc_check(VecScatterBegin(scatter_, stored_, whole_, INSERT_VALUES, SCATTER_FORWARD));
  petsc_check(VecScatterEnd(scatter_, stored_, whole_, INSERT_VALUES, SCATTER_FORWARD));
  DistributedArray array = extents();
  const VecReading whole(whole_);
  for (const double value : whole.values()) array.values.push_back(scale * value);
  return array;
}

DistributedArray WholeDomain::coordinates(double scale) const {
  DistributedArray array = extents();
  array.all.push_back(2);
  array.begin.push_back(0);
  array.count.push_back(2);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int row = first_row(); row < end_row(); ++row) {
      array.values.push_back(scale * grid_.x(i));
      array.values.push_back(scale * y(row));
    }
  }
  return array;
}

}  // namespace gearfilm
