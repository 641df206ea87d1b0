// What a run says on stderr while it goes on.
#pragma once

#include "gearfilm/parallel/petsc.hpp"
#include "input/plain_text.hpp"

namespace gearfilm {

inline void warn(MPI_Comm comm, const std::string& text) {
  petsc_check(PetscFPrintf(comm, stderr, "gearfilm: warning: %s\n", one_line(text).c_str()));
}

}  // namespace gearfilm
