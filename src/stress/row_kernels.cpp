#include "stress/row_kernels.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

// Half the length of the cells of a line contact, which are endless [a]: stresses are off by its square, 1e-6.
constexpr double endless = 1e3;

std::vector<Strip> cells_of(const RowAxis& rows, int row) {
  if (rows.single()) return {{-endless, endless}};
  const Strip own = rows.strip(row);
  if (!rows.mirrored() || row == rows.mirror_row()) return {own};
  return {own, {-own.upper, -own.lower}};
}

}  // namespace

RowKernels::RowKernels(const Grid& grid, const StripLattice& lattice) : lattice_(lattice), transform_(lattice) {
  for (int j = 0; j < grid.y_count(); ++j) own_.push_back(cells_of(grid.row_axis(), grid.y_begin() + j));
}

void RowKernels::at(double y, double z, SurfaceLoad load, double poisson_ratio, std::span<double> kernels) {
  const std::size_t waves = lattice_.waves(), rows = own_.size();
  std::vector<double> of_row(stress_components * waves);
  for (std::size_t j = 0; j < rows; ++j) {
    std::ranges::fill(of_row, 0.0);
    for (const Strip& cell : own_[j]) transform_.add(load, {cell.lower - y, cell.upper - y}, z, poisson_ratio, of_row);
    for (std::size_t c = 0; c < stress_components; ++c) {
      for (std::size_t k = 0; k < waves; ++k) {
        kernels[(c * rows + j) * waves + k] = of_row[c * waves + k] / lattice_.length;
      }
    }
  }
}

}  // namespace gearfilm
