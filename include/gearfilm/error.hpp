// The ways in which a command ends early, each with its exit status (docs/guide/running.md), and how messages are
// worded.
#pragma once

#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>

namespace gearfilm {

/// Text of a message from words and numbers, written one after the other as a stream writes them. A manipulator acts on
/// the parts behind it.
template <class... Parts>
std::string worded(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// Base of all exceptions of the library: its message is made of words and numbers.
class Worded : public std::runtime_error {
public:
  template <class... Parts>
  explicit Worded(const Parts&... parts) : std::runtime_error(worded(parts...)) {}
};

/// The input is wrong: the message says what, the value, and what to do. Raised on all processes
/// alike, before anything is written. Exit status 1.
class InputError : public Worded {
public:
  using Worded::Worded;
};

/// Base of SolveError and Stopped: the computation ended early, and what it computed until then may be written.
class Unfinished : public Worded {
public:
  using Worded::Worded;
};

/// The computation failed: not converged, or outside its model's validity. The message names the
/// contact, the position and the remedy. Exit status 2.
class SolveError : public Unfinished {
public:
  using Unfinished::Unfinished;
};

/// Results cannot be written any more: disk full, folder gone. Raised on all processes alike. Exit status 2.
class OutputError : public Worded {
public:
  using Worded::Worded;
};

/// Stopped on request, by a signal or the time limit; can be continued. Raised on all processes alike. Exit status 3.
class Stopped : public Unfinished {
public:
  using Unfinished::Unfinished;
};

/// A run that was to be continued is complete already; the message says so. Exit status 0.
class NothingLeft : public Worded {
public:
  using Worded::Worded;
};

}  // namespace gearfilm
