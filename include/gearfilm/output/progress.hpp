// Progress of a long run: one line that renews itself on a terminal, plain lines otherwise.
#pragma once

#include <mpi.h>

#include <string>

namespace gearfilm {

class Progress {
public:
  explicit Progress(MPI_Comm comm);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Reports that `fraction` of the work is done, with a text; adds the time left. Most calls print nothing: on a
  /// terminal at most five times a second, otherwise at every twentieth of the work.
  void report(double fraction, const std::string& text);
  /// A line of its own.
  void note(const std::string& text);

private:
  bool prints_;
  bool terminal_;
  bool line_open_ = false;
  double start_;
  double last_print_ = 0.0;
  int last_part_ = 0;
};

/// Progress of work of which nobody knows how much is left: silent for five seconds, then what it is at. On a terminal
/// one line that renews itself and is gone in the end; otherwise lines that become rarer, a minute apart at most.
class LongWork {
public:
  explicit LongWork(MPI_Comm comm);
  ~LongWork();
  LongWork(const LongWork&) = delete;
  LongWork& operator=(const LongWork&) = delete;

  void report(const std::string& text);
  /// A line of its own.
  void note(const std::string& text);

private:
  bool prints_;
  bool terminal_;
  bool line_open_ = false;
  double start_;
  double due_;  ///< seconds from the start to the next print
};

}  // namespace gearfilm
