// What waiting for another process costs the core.
#include "parallel/patient_waits.hpp"

#include <gtest/gtest.h>
#include <petscsys.h>
#include <sched.h>

#include <chrono>
#include <ctime>
#include <string>
#include <thread>

namespace gearfilm {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds long_wait{200};

double core_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

bool is_open_mpi() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  return std::string(text).starts_with("Open MPI");
}

class PatientWaits : public testing::Test {
protected:
  void SetUp() override { sleep_in_long_waits(true); }
  void TearDown() override { sleep_in_long_waits(false); }
};

TEST_F(PatientWaits, sleep_where_they_are_long) {
  const double before = core_seconds();
  const Clock::time_point end = Clock::now() + long_wait;
  while (Clock::now() < end) sched_yield();
  EXPECT_LT(core_seconds() - before, 0.1 * std::chrono::duration<double>(long_wait).count());
}

TEST_F(PatientWaits, are_those_of_open_mpi) {
  int rank = 0, size = 1;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  MPI_Comm_size(PETSC_COMM_WORLD, &size);
  if (size == 1 || !is_open_mpi()) GTEST_SKIP();
  MPI_Barrier(PETSC_COMM_WORLD);
  const double before = core_seconds();
  if (rank == size - 1) std::this_thread::sleep_for(long_wait);
  int sum = 0;
  MPI_Allreduce(&rank, &sum, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  EXPECT_LT(core_seconds() - before, 0.25 * std::chrono::duration<double>(long_wait).count());
}

}  // namespace
}  // namespace gearfilm
