#include "parallel/first_processes.hpp"

#include "parallel/agreement.hpp"

namespace gearfilm {

FirstProcesses::FirstProcesses(MPI_Comm all, int count) {
  const int rank = rank_in(all);
  MPI_Comm_split(all, rank < count ? 0 : MPI_UNDEFINED, rank, &comm_);
}

FirstProcesses::~FirstProcesses() {
  if (contain_this()) MPI_Comm_free(&comm_);
}

}  // namespace gearfilm
