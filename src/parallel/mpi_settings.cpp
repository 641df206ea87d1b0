#include "parallel/mpi_settings.hpp"

#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "parallel/patient_waits.hpp"

namespace gearfilm {
namespace {

/// 4 for Open MPI 4.1.4; 0 for another implementation.
int open_mpi_generation() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0, generation = 0;
  MPI_Get_library_version(text, &length);  // allowed before MPI_Init
  return std::sscanf(text, "Open MPI v%d", &generation) == 1 ? generation : 0;
}

void prefer(const char* name, const char* value) { setenv((std::string("OMPI_MCA_") + name).c_str(), value, 0); }

/// Without mpiexec or a batch system, which tell every process by one of these which of them it is.
bool is_alone() {
  const char* const told_by[] = {"PMIX_NAMESPACE", "OMPI_COMM_WORLD_RANK", "PMI_RANK",
                                 "PMI_FD",         "SLURM_PROCID",         "ALPS_APP_PE"};
  return std::ranges::none_of(told_by, [](const char* name) { return std::getenv(name) != nullptr; });
}

bool is_on_one_machine() {
  const char* all = std::getenv("OMPI_COMM_WORLD_SIZE");
  const char* here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  return all && here && std::string(all) == here;
}

}  // namespace

void prefer_mpi_settings() {
  const int generation = open_mpi_generation();
  if (generation == 0) return;
  if (has_own_core()) {
    sleep_in_long_waits(true);
    prefer("mpi_yield_when_idle", "1");
  }
  // OMPIO, the default for parallel files, leaves a semaphore behind when a run is killed inside a file open; every
  // later open of a file of that name then hangs. ROMIO does not. Where there is none (from Open MPI 6 on, and where it
  // was not built), OMPIO has to do without the part that has the semaphore.
  prefer("io_ompio_priority", "1");
  prefer("sharedfp", "^sm");
  // More than 4 kB go between processes of one machine by a system call, which takes as long as a whole transpose of
  // 129 x 65 nodes.
  prefer(generation < 5 ? "btl_vader_eager_limit" : "btl_sm_eager_limit", "16384");
  if (is_alone()) {
    // Which starts a daemon for processes that it might spawn, and looks for networks: two thirds of a short run. From
    // Open MPI 5 on it leaves the file of its shared memory behind.
    prefer("ess_singleton_isolated", "1");
    prefer("pml", "ob1");
    prefer("btl", "self");
  } else if (generation >= 5 && is_on_one_machine()) {
    prefer("btl", "^tcp");  // it complains where there is no network
  }
}

}  // namespace gearfilm
