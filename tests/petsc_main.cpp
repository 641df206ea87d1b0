// Main of the GoogleTest programs that run under mpiexec.
//
// Every process runs the same tests in the same order, since most of them are collective. The first process reports
// as GoogleTest does, the others only their failures. The exit status is non-zero on all processes if a test failed
// on any of them.
#include <gtest/gtest.h>
#include <slepcsys.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "parallel/mpi_settings.hpp"

namespace {

class FailurePrinter : public testing::EmptyTestEventListener {
public:
  explicit FailurePrinter(int rank) : rank_(rank) {}

  // GoogleTest holds its lock while it reports a result: asking it for the current test there would wait for ever.
  void OnTestStart(const testing::TestInfo& test) override {
    test_ = std::string(test.test_suite_name()) + "." + test.name();
  }

  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    std::fprintf(stderr, "[process %d] %s\n%s:%d: %s\n", rank_, test_.c_str(),
                 result.file_name() ? result.file_name() : "", result.line_number(), result.message());
  }

private:
  int rank_;
  std::string test_;
};

void report_failures_only(int rank) {
  auto& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  delete listeners.Release(listeners.default_xml_generator());
  listeners.Append(new FailurePrinter(rank));
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  gearfilm::prefer_mpi_settings();
  if (SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0) return EXIT_FAILURE;
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  if (rank != 0) report_failures_only(rank);
  int status = RUN_ALL_TESTS();
  MPI_Allreduce(MPI_IN_PLACE, &status, 1, MPI_INT, MPI_MAX, PETSC_COMM_WORLD);
  if (SlepcFinalize() != 0) return EXIT_FAILURE;
  return status;
}
