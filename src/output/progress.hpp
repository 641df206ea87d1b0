// Progress of a long run: one line that renews itself on a terminal, plain lines otherwise.
#pragma once

#include <mpi.h>

#include <string>

namespace gearfilm {

/// The last line of standard output, which the first process alone prints.
class StatusLine {
public:
  explicit StatusLine(MPI_Comm comm);

  bool prints() const { return prints_; }
  bool on_terminal() const { return terminal_; }
  double elapsed() const { return MPI_Wtime() - start_; }  ///< since it was made [s]

  /// On a terminal in the place of the line before, otherwise a line of its own.
  void renew(const std::string& text);
  /// A line that stays.
  void note(const std::string& text);
  /// Ends a line that renews itself, which stays or goes.
  void end(bool stays);

private:
  bool prints_;
  bool terminal_;
  bool open_ = false;
  double start_;
};

class Progress {
public:
  explicit Progress(MPI_Comm comm) : line_(comm) {}
  ~Progress() { line_.end(true); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Reports that `fraction` of the work is done, with a text; adds the time left. Most calls print nothing: on a
  /// terminal at most five times a second, otherwise at every twentieth of the work.
  void report(double fraction, const std::string& text);
  /// A line of its own.
  void note(const std::string& text) { line_.note(text); }

private:
  StatusLine line_;
  double last_print_ = 0.0;  ///< [s] from the start
  int last_part_ = 0;
};

/// Progress of work of which nobody knows how much is left: silent for some seconds, then what it is at. On a terminal
/// one line that renews itself and is gone in the end; otherwise lines that become rarer, a minute apart at most.
class LongWork {
public:
  explicit LongWork(MPI_Comm comm, double silent_seconds = 5.0) : line_(comm), due_(silent_seconds) {}
  ~LongWork() { line_.end(false); }
  LongWork(const LongWork&) = delete;
  LongWork& operator=(const LongWork&) = delete;

  void report(const std::string& text);
  /// A line of its own.
  void note(const std::string& text) { line_.note(text); }

private:
  StatusLine line_;
  double due_;  ///< seconds from the start to the next print
};

}  // namespace gearfilm
