// The kinds of failure that reach the user, each with its exit status (docs/user-guide.md).
#pragma once

#include <stdexcept>

namespace gearfilm {

/// The input is wrong: the message says what, the value, and what to do. Raised on all processes
/// alike, before anything is written. Exit status 1.
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The computation failed: not converged, or outside its model's validity. The message names the
/// contact, the position and the remedy. Exit status 2.
class SolveError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

}  // namespace gearfilm
