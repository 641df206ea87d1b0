#include "grid/integral.hpp"

#include <numeric>

namespace gearfilm {
namespace {

/// Int Int over the own rows and their mirror images, for h_x = 1. Sums over each row run side by side, for vector
/// instructions.
double own_part(const Grid& grid, std::span<const double> values) {
  const std::span<const double> weights = grid.row_weights();
  std::vector<double> sums(weights.size());
  for (std::size_t first = 0; first < values.size(); first += sums.size()) {
    const double* line = values.data() + first;
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += line[j];
  }
  return std::inner_product(sums.begin(), sums.end(), weights.begin(), 0.0);
}

}  // namespace

std::vector<double> integrals(const Grid& grid, std::span<const double> values, std::size_t fields) {
  const std::size_t size = fields == 0 ? 0 : values.size() / fields;
  std::vector<double> sums(fields);
  for (std::size_t k = 0; k < fields; ++k) sums[k] = own_part(grid, values.subspan(k * size, size));
  if (grid.processes() > 1) {
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(fields), MPI_DOUBLE, MPI_SUM, grid.comm());
  }
  for (double& sum : sums) sum *= grid.h_x();
  return sums;
}

double integral(const Grid& grid, std::span<const double> values) { return integrals(grid, values, 1).front(); }

}  // namespace gearfilm
