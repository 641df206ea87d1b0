// The warning about teeth that meet their mates under load before the path of contact begins.
#pragma once

#include "mesh/mesh_model.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {

/// Warns where an entering contact meets its mate at once under the static force.
void warn_of_corner_contact(MPI_Comm comm, const MeshModel& mesh);

}  // namespace gearfilm
