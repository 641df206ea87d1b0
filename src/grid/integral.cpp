#include "grid/integral.hpp"

#include <numeric>

namespace gearfilm {
namespace {

/// Sums over each own row. They run side by side, for vector instructions.
std::vector<double> row_sums(const Grid& grid, std::span<const double> values) {
  std::vector<double> sums(grid.row_weights().size());
  for (std::size_t first = 0; first < values.size(); first += sums.size()) {
    const double* line = values.data() + first;
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += line[j];
  }
  return sums;
}

/// Int Int over the own rows and their mirror images, for h_x = 1.
double own_part(const Grid& grid, std::span<const double> values) {
  const std::vector<double> sums = row_sums(grid, values);
  return std::inner_product(sums.begin(), sums.end(), grid.row_weights().begin(), 0.0);
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

std::vector<double> parts_of_rows(const Grid& grid, std::span<const double> values) {
  std::vector<double> parts = row_sums(grid, values);
  for (std::size_t j = 0; j < parts.size(); ++j) parts[j] *= grid.h_x() * grid.row_weights()[j];
  return parts;
}

}  // namespace gearfilm
