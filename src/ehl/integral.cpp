#include "gearfilm/ehl/integral.hpp"

#include <array>

namespace gearfilm {

double integral(const Grid& grid, std::span<const double> values) {
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
  // Both halves of the domain, with the nodes on Y = 0 once.
  sum *= 2.0;
  if (grid.rank() == 0) {
    for (n = 0; n < count; n += grid.y_count()) sum -= values[n];
  }
  if (grid.processes() > 1) MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, grid.comm());
  return sum * grid.h_x() * grid.h_y();
}

}  // namespace gearfilm
