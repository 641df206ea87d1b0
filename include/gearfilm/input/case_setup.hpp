// From a case to the objects that solve it.
#pragma once

#include "gearfilm/dynamics/mesh_march.hpp"
#include "gearfilm/input/case.hpp"

namespace gearfilm {

/// The grid of a case.
GridShape case_grid(const Case& problem);
/// What all films of a case share. Collective.
SharedDiscretisation discretise(MPI_Comm comm, const Case& problem);
/// Throws InputError unless the case is a gear pair with inertia.
void require_inertia(const Case& problem);
/// Throws InputError for a case whose march is of dry contacts, or of contacts that are held, where a command needs
/// lubricated ones that travel.
void require_moving_films(const Case& problem, const std::string& command);
/// A march of the case's lubricated pair.
MeshMarch make_march(const Case& problem, const SharedDiscretisation& films, const ContactPath& path,
                     StepObserver observer, MarchKeeper* keeper = nullptr);
/// The dry pair's orbit, damped about as films do.
DryOrbit damped_dry_orbit(const Case& problem, const ContactPath& path);
/// Where the search for the case's periodic state begins: that orbit, its H_0 shifted by the film.
OrbitGuess dry_guess(const Case& problem, const SharedDiscretisation& films, const DryOrbit& dry);
/// The path of a march that starts just after a contact has left.
ContactPath path_after_leaving(const Case& problem);

}  // namespace gearfilm
