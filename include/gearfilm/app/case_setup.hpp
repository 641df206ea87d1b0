// From a case to the objects that solve it.
#pragma once

#include "gearfilm/dynamics/mesh_march.hpp"
#include "gearfilm/io/case.hpp"

namespace gearfilm {

/// The grid of a case.
GridShape case_grid(const Case& problem);
/// Throws InputError unless the case is a gear pair with inertia.
void require_inertia(const Case& problem);
/// A march of the case's lubricated pair.
MeshMarch make_march(const Case& problem, const Grid& grid, const ContactPath& path, StepObserver observer);
/// H_0 of the stationary film under the static force at the pitch point, less that of the dry contact.
double stationary_film_shift(const Case& problem, const Grid& grid);
/// The path of a march that starts just after a contact has left.
ContactPath path_after_leaving(const Case& problem);

}  // namespace gearfilm
