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
constexpr double silent_seconds = 5.0;
constexpr double rarer = 1.5;  // plain lines of long work, each at that many times the seconds of the one before
constexpr double rarest_seconds = 60.0;

// Open MPI gives a process a pseudo-terminal for its standard output even when that of mpiexec goes to a file; its
// standard error stays a pipe.
bool on_terminal() { return isatty(STDOUT_FILENO) != 0 && isatty(STDERR_FILENO) != 0; }

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

/// A line that stays, in the place of one that renews itself.
void print_line(const std::string& text, bool terminal) {
  std::printf(terminal ? "\r\033[K%s\n" : "%s\n", text.c_str());
  std::fflush(stdout);
}

}  // namespace

Progress::Progress(MPI_Comm comm) : prints_(rank_in(comm) == 0), terminal_(on_terminal()), start_(MPI_Wtime()) {}

Progress::~Progress() {
  if (line_open_) std::printf("\n");
}

void Progress::note(const std::string& text) {
  if (!prints_) return;
  print_line(text, terminal_);
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
  last_print_ = now;
  std::printf(terminal_ ? "\r\033[K%s" : "%s\n", (percent + text + left).c_str());
  std::fflush(stdout);
  line_open_ = terminal_;
}

LongWork::LongWork(MPI_Comm comm)
    : prints_(rank_in(comm) == 0), terminal_(on_terminal()), start_(MPI_Wtime()), due_(silent_seconds) {}

LongWork::~LongWork() {
  if (!line_open_) return;
  std::printf("\r\033[K");
  std::fflush(stdout);
}

void LongWork::note(const std::string& text) {
  if (!prints_) return;
  print_line(text, terminal_);
  line_open_ = false;
}

void LongWork::report(const std::string& text) {
  if (!prints_) return;
  const double elapsed = MPI_Wtime() - start_;
  if (elapsed < due_) return;
  due_ = terminal_ ? elapsed + seconds_between_updates : std::min(rarer * elapsed, elapsed + rarest_seconds);
  std::printf(terminal_ ? "\r\033[K%s: %s" : "%s: %s\n", duration(elapsed).c_str(), text.c_str());
  std::fflush(stdout);
  line_open_ = terminal_;
}

}  // namespace gearfilm
