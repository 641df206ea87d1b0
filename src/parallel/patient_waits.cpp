#include "gearfilm/parallel/patient_waits.hpp"

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace gearfilm {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

constexpr microseconds apart{10};       // calls further apart than this belong to two waits
constexpr microseconds short_wait{50};  // as those are between processes that all run
constexpr int part = 16;                // of what has been waited, to be slept at a time
constexpr microseconds shortest_sleep{5}, longest_sleep{500};

/// Of the process: MPI waits on one thread.
struct Wait {
  Clock::time_point begin{}, last{};
};
Wait wait;

void wait_a_little() {
  const Clock::time_point now = Clock::now();
  if (now - wait.last > apart) wait.begin = now;
  const nanoseconds waited = now - wait.begin;
  if (waited > short_wait) {
    std::this_thread::sleep_for(std::clamp<nanoseconds>(waited / part, shortest_sleep, longest_sleep));
    wait.last = Clock::now();
  } else {
    wait.last = now;
  }
}

}  // namespace

void wait_patiently() {
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
#ifdef __linux__
  prctl(PR_SET_TIMERSLACK, 1000UL);  // [ns]; 50 us else
#endif
}

}  // namespace gearfilm

/// In the place of the C library's, which gives the core to nobody where the kernel shares it fairly.
extern "C" int sched_yield() noexcept {
  gearfilm::wait_a_little();
  return 0;
}
