#include "output/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

constexpr double seconds_between_updates = 0.2;
constexpr int plain_lines = 20;
constexpr double rarer = 1.5;  // plain lines of long work, each at that many times the seconds of the one before
constexpr double rarest_seconds = 60.0;

// Open MPI gives a process a pseudo-terminal for its standard output even when that of mpiexec goes to a file; its
// standard error stays a pipe.
bool is_terminal() { return isatty(STDOUT_FILENO) != 0 && isatty(STDERR_FILENO) != 0; }

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

StatusLine::StatusLine(MPI_Comm comm, bool stays)
    : prints_(rank_in(comm) == 0), terminal_(is_terminal()), stays_(stays), start_(MPI_Wtime()) {}

void StatusLine::renew(const std::string& text) {
  if (!prints_) return;
  std::printf(terminal_ ? "\r\033[K%s" : "%s\n", text.c_str());
  std::fflush(stdout);
  open_ = terminal_;
}

void StatusLine::note(const std::string& text) {
  if (!prints_) return;
  std::printf(terminal_ ? "\r\033[K%s\n" : "%s\n", text.c_str());
  std::fflush(stdout);
  open_ = false;
}

StatusLine::~StatusLine() {
  if (!open_) return;
  std::printf(stays_ ? "\n" : "\r\033[K");
  std::fflush(stdout);
}

void Progress::report(double fraction, const std::string& text) {
  if (!prints() || fraction <= 0.0) return;
  const double now = elapsed();
  const int part = static_cast<int>(fraction * plain_lines + 1e-9);
  const bool due = on_terminal() ? now - last_print_ > seconds_between_updates || fraction >= 1.0 : part > last_part_;
  if (!due) return;
  last_part_ = part;
  last_print_ = now;
  const std::string left = fraction >= 1.0 ? "" : ", " + duration(now * (1.0 / fraction - 1.0)) + " left";
  char percent[16];
  std::snprintf(percent, sizeof percent, "%3.0f %%  ", 100.0 * fraction);
  renew(percent + text + left);
}

void LongWork::report(const std::string& text) {
  const double now = elapsed();
  if (!prints() || now < due_) return;
  due_ = on_terminal() ? now + seconds_between_updates : std::min(rarer * now, now + rarest_seconds);
  renew(duration(now) + ": " + text);
}

}  // namespace gearfilm
