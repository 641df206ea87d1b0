// Progress of a long run: one line that renews itself on a terminal, plain lines otherwise.
#pragma once

#include <mpi.h>

#include <string>

namespace gearfilm {

/// The last line of standard output, which the first process alone prints.
class StatusLine {
public:
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// A line of its own.
  void note(const std::string& text);

protected:
  /// stays: a line that renews itself, in the end.
  StatusLine(MPI_Comm comm, bool stays);
  ~StatusLine();

  bool prints() const { return prints_; }
  bool on_terminal() const { return terminal_; }
  double elapsed() const { return MPI_Wtime() - start_; }  ///< since it was made [s]
  /// Shows a text: on a terminal in the place of the line before, otherwise in a line of its own.
  void renew(const std::string& text);

private:
  bool prints_;
  bool terminal_;
  bool stays_;
  bool open_ = false;
  double start_;
};

class Progress : public StatusLine {
public:
  explicit Progress(MPI_Comm comm) : StatusLine(comm, true) {}

  /// Reports that `fraction` of the work is done, with a text; adds the time left. Most calls print nothing: on a
  /// terminal at most five times a second, otherwise at every twentieth of the work.
  void report(double fraction, const std::string& text);

private:
  double last_print_ = 0.0;  ///< [s] from the start
  int last_part_ = 0;
};

/// Progress of work whose remaining amount is not known. It is silent for some seconds, then shows what is being done:
/// on a terminal in one line that renews itself and is gone in the end, otherwise in lines that become rarer, a minute
/// apart at most.
class LongWork : public StatusLine {
public:
  explicit LongWork(MPI_Comm comm, double silent_seconds = 5.0) : StatusLine(comm, false), due_(silent_seconds) {}

  void report(const std::string& text);

private:
  double due_;  ///< seconds from the start to the next print
};

}  // namespace gearfilm
