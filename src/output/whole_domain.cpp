#include "output/whole_domain.hpp"

namespace gearfilm {

WholeDomain::WholeDomain(const Grid& grid)
    : grid_(grid), cuts_(cut_evenly(grid.ny(), grid.processes())), scatter_(grid, sources()) {}

std::vector<PetscInt> WholeDomain::sources() const {
  std::vector<PetscInt> sources;
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int row = first_row(); row < end_row(); ++row) {
      sources.push_back(grid_.vec_index(i, grid_.row_axis().stored_row(row)));
    }
  }
  return sources;
}

DistributedArray WholeDomain::extents() const {
  const auto lines = static_cast<hsize_t>(grid_.nx()), rows = static_cast<hsize_t>(grid_.ny());
  const auto first = static_cast<hsize_t>(first_row()), end = static_cast<hsize_t>(end_row());
  return {{lines, rows}, {0, first}, {lines, end - first}, {}};
}

DistributedArray WholeDomain::unfold(const Field<double>& values, double scale) const {
  std::vector<double> own(grid_.local_size());
  values.store(own);
  DistributedArray array = extents();
  array.values.resize(static_cast<std::size_t>(grid_.nx()) * (end_row() - first_row()));
  scatter_(own, array.values);
  for (double& value : array.values) value *= scale;
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
