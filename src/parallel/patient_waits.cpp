#include "parallel/patient_waits.hpp"

#ifdef __linux__
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace gearfilm {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

constexpr microseconds apart{10};        // calls further apart than this belong to two waits
constexpr microseconds short_wait{500};  // longer than those between processes that all run
constexpr int part = 16;                 // of what has been waited, to be slept at a time
constexpr microseconds longest_sleep{500};

bool sleeps = false;

int cores_of(pid_t process) {
  cpu_set_t cores;
  return sched_getaffinity(process, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 0;
}

void wait_a_little() {
  thread_local Clock::time_point begin{}, last{};
  const Clock::time_point now = Clock::now();
  if (now - last > apart) begin = now;
  const nanoseconds waited = now - begin;
  if (waited > short_wait) std::this_thread::sleep_for(std::min<nanoseconds>(waited / part, longest_sleep));
  last = Clock::now();
}

}  // namespace

bool has_own_core() {
  const char* processes = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  const int cores = cores_of(getppid());
  return processes && std::atoi(processes) <= cores && cores_of(0) < cores;
}

void sleep_in_long_waits(bool yes) {
  sleeps = yes;
  if (yes) prctl(PR_SET_TIMERSLACK, 1000UL);  // [ns]; 50 us else
}

}  // namespace gearfilm

/// In the place of the C library's.
extern "C" int sched_yield() noexcept {
  if (!gearfilm::sleeps) return static_cast<int>(syscall(SYS_sched_yield));
  gearfilm::wait_a_little();
  return 0;
}

#else

namespace gearfilm {

bool has_own_core() { return false; }

void sleep_in_long_waits(bool) {}

}  // namespace gearfilm

#endif
