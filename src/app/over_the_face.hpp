// Runs whose contacts end within the face at rest and come to its edges in motion: they begin again with films over
// the whole face. Forces of a pair in motion are known when they are computed.
#pragma once

#include <functional>
#include <string>

#include "input/case.hpp"

namespace gearfilm {

/// run: on a case. Where a contact has come to the edges, this is said, and run is called again with films over the
/// whole face. A run that did so before goes on there. Collective.
void run_over_the_face_if_needed(MPI_Comm comm, const CaseInput& given, const std::string& what,
                                 const std::function<void(const CaseInput&)>& run);

}  // namespace gearfilm
