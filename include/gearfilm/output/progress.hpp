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
  /// The same of work whose end is not known: on a terminal at most five times a second, otherwise a second after the
  /// beginning and every five seconds from then on.
  void report(const std::string& text);
  /// A line of its own.
  void note(const std::string& text);

private:
  void print(const std::string& line, double now);

  bool prints_;
  bool terminal_;
  bool line_open_ = false;
  double start_;
  double last_print_ = 0.0;
  int last_part_ = 0;
};

}  // namespace gearfilm
