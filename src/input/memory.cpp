#include "input/memory.hpp"

#include <unistd.h>

#include <cmath>

#include "gearfilm/error.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

// Bytes that one contact takes for each of its nodes, beyond the 54 MB of a process. Measured: 306 and 299 for a
// stationary film on 513 x 513 and 1025 x 1025 nodes, 369 for a march on 1025 x 513; 826 for two contacts on 513 x 257.
constexpr double bytes_per_node = 300.0;
// Where a film feels its heat, for each point across it: 87 for a stationary film on 513 x 513 nodes with 17 points.
constexpr double bytes_per_point = 87.0;

double memory_of_all_machines(MPI_Comm comm) {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  const int rank = rank_in(machine);
  MPI_Comm_free(&machine);
  double bytes =
      rank == 0 ? static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0.0;
  MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_DOUBLE, MPI_SUM, comm);
  return bytes;
}

}  // namespace

void require_memory(MPI_Comm comm, int nx, int ny, int contacts, int heated_points) {
  const double needed = (bytes_per_node + bytes_per_point * heated_points) * contacts * nx * ny,
               present = memory_of_all_machines(comm);
  if (needed <= present) return;
  throw InputError("a grid of ", nx, " x ", ny, " nodes for ", contacts, (contacts == 1 ? " contact" : " contacts"),
                   " needs at least ", std::ceil(needed * 1e-9), " GB of memory, and there are ",
                   std::floor(present * 1e-9), " GB; lower grid.nx and grid.ny, or use more machines");
}

}  // namespace gearfilm
