#include "gearfilm/output/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gearfilm/parallel/agreement.hpp"

namespace gearfilm {
namespace {

constexpr double seconds_between_updates = 0.2;
constexpr int plain_lines = 20;
constexpr double seconds_to_first_line = 1.0, seconds_between_lines = 5.0;  // of work without a known end, plain

std::string duration(double seconds) {
  const long whole = std::lround(seconds);
  char text[32];
  if (whole >= 3600) {
    std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole % 3600 / 60);
  } else if (whole >= 60) {
    std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld s", whole);
  }
  return text;
}

}  // namespace

// Open MPI gives a process a pseudo-terminal for its standard output even when that of mpiexec goes to a file; its
// standard error stays a pipe.
Progress::Progress(MPI_Comm comm)
    : prints_(rank_in(comm) == 0),
      terminal_(isatty(STDOUT_FILENO) != 0 && isatty(STDERR_FILENO) != 0),
      start_(MPI_Wtime()) {}

Progress::~Progress() {
  if (line_open_) std::printf("\n");
}

void Progress::note(const std::string& text) {
  if (!prints_) return;
  std::printf(terminal_ ? "\r\033[K%s\n" : "%s\n", text.c_str());
  std::fflush(stdout);
  line_open_ = false;
}

void Progress::report(double fraction, const std::string& text) {
  if (!prints_ || fraction <= 0.0) return;
  const double now = MPI_Wtime();
  const int part = static_cast<int>(fraction * plain_lines + 1e-9);
  const bool due = terminal_ ? now - last_print_ > seconds_between_updates || fraction >= 1.0 : part > last_part_;
  if (!due) return;
  last_part_ = part;
  const std::string left = fraction >= 1.0 ? "" : ", " + duration((now - start_) * (1.0 / fraction - 1.0)) + " left";
  char percent[16];
  std::snprintf(percent, sizeof percent, "%3.0f %%  ", 100.0 * fraction);
  print(percent + text + left, now);
}

void Progress::report(const std::string& text) {
  if (!prints_) return;
  const double now = MPI_Wtime();
  const double plain_wait = last_print_ > 0.0 ? seconds_between_lines : seconds_to_first_line;
  if (now - std::max(last_print_, start_) > (terminal_ ? seconds_between_updates : plain_wait)) print(text, now);
}

void Progress::print(const std::string& line, double now) {
  last_print_ = now;
  std::printf(terminal_ ? "\r\033[K%s" : "%s\n", line.c_str());
  std::fflush(stdout);
  line_open_ = terminal_;
}

}  // namespace gearfilm
