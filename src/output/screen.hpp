// What a run says while it goes on.
#pragma once

#include "gearfilm/error.hpp"
#include "input/plain_text.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {

/// A line on the screen, of words and numbers.
template <class... Parts>
void say(MPI_Comm comm, const Parts&... parts) {
  petsc_check(PetscPrintf(comm, "%s\n", worded(parts...).c_str()));
}

/// A warning on stderr, of words and numbers.
template <class... Parts>
void warn(MPI_Comm comm, const Parts&... parts) {
  petsc_check(PetscFPrintf(comm, stderr, "gearfilm: warning: %s\n", one_line(worded(parts...)).c_str()));
}

}  // namespace gearfilm
