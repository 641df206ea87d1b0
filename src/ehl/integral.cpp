#include "gearfilm/ehl/integral.hpp"

#include <array>

namespace gearfilm {
namespace {

/// Of both halves of the domain, with the nodes on Y = 0 once.
double own_sum(const Grid& grid, std::span<const double> values) {
  const std::size_t count = values.size();
  constexpr std::size_t lanes = 16;  // sums side by side, for vector instructions
  std::array<double, lanes> sums{};
  std::size_t n = 0;
  for (; n + lanes <= count; n += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) sums[lane] += values[n + lane];
  }
  double sum = 0.0;
  for (; n < count; ++n) sum += values[n];
  for (const double part : sums) sum += part;
  sum *= 2.0;
  if (grid.rank() == 0) {
    for (n = 0; n < count; n += grid.y_count()) sum -= values[n];
  }
  return sum;
}

}  // namespace

std::vector<double> integrals(const Grid& grid, std::span<const double> values, std::size_t fields) {
  const std::size_t size = fields == 0 ? 0 : values.size() / fields;
  std::vector<double> sums(fields);
  for (std::size_t k = 0; k < fields; ++k) sums[k] = own_sum(grid, values.subspan(k * size, size));
  if (grid.processes() > 1) {
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(fields), MPI_DOUBLE, MPI_SUM, grid.comm());
  }
  for (double& sum : sums) sum *= grid.h_x() * grid.h_y();
  return sums;
}

double integral(const Grid& grid, std::span<const double> values) { return integrals(grid, values, 1).front(); }

}  // namespace gearfilm
