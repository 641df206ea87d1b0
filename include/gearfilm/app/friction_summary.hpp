// What summaries say of friction and heat beside the figures of contacts: formulas, efficiency, warnings.
#pragma once

#include "gearfilm/input/case.hpp"
#include "gearfilm/output/summary.hpp"

namespace gearfilm {

/// Formulas for friction and heating of a contact with a computed friction coefficient; empty without friction, and of
/// heat only what the oil's data allow.
Summary friction_predictions(const Case& problem, const ContactSolids& solids, const ContactOperation& operation,
                             const SurfaceVelocities& velocities, double friction_coefficient);

/// L_T and thermal factors of the film; empty where the oil's temperature law is not known.
Summary heating_predictions(const Case& problem, const ContactSolids& solids, const ContactOperation& operation,
                            double slide_ratio);

/// The same at the reference contact.
Summary heating_at_pitch(const Case& problem);

/// Says where the film of an isothermal run is far too thick, since shear heats its inlet.
void warn_of_heating(MPI_Comm comm, const Case& problem, const Summary& heating);
/// Says where temperatures across the film did not settle.
void warn_of_missed_temperatures(MPI_Comm comm, const Summary& summary, const char* missed);
/// Says where the film is thinner than the flanks are rough.
void warn_of_roughness(MPI_Comm comm, const Summary& summary, const char* film_ratio);

/// Adds efficiency and mean friction coefficient to a summary that has the losses of whole mesh periods.
void add_efficiency(const MeshModel& mesh, Summary& summary);

}  // namespace gearfilm
