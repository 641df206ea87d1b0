#include "gearfilm/ehl/gather.hpp"

#include <algorithm>

namespace gearfilm {

Gather::Gather(const Grid& grid) : grid_(grid), counts_(grid.processes()), offsets_(grid.processes()) {
  for (int p = 0; p < grid.processes(); ++p) {
    counts_[p] = grid.nx() * (grid.y_ranges()[p + 1] - grid.y_ranges()[p]);
    offsets_[p] = grid.nx() * grid.y_ranges()[p];
  }
  blocks_.resize(static_cast<std::size_t>(grid.nx()) * grid.rows());
}

void Gather::to_all(const double* own, double* whole) {
  MPI_Allgatherv(own, grid_.local_size(), MPI_DOUBLE, blocks_.data(), counts_.data(), offsets_.data(), MPI_DOUBLE,
                 grid_.comm());
  for (int p = 0; p < grid_.processes(); ++p) {
    const int rows = grid_.y_ranges()[p + 1] - grid_.y_ranges()[p];
    for (int i = 0; i < grid_.nx(); ++i) {
      std::copy_n(blocks_.data() + offsets_[p] + static_cast<std::size_t>(i) * rows, rows,
                  whole + static_cast<std::size_t>(i) * grid_.rows() + grid_.y_ranges()[p]);
    }
  }
}

void Gather::own_part(const double* whole, double* own) const {
  for (int i = 0; i < grid_.nx(); ++i) {
    std::copy_n(whole + static_cast<std::size_t>(i) * grid_.rows() + grid_.y_begin(), grid_.y_count(),
                own + static_cast<std::size_t>(i) * grid_.y_count());
  }
}

}  // namespace gearfilm
