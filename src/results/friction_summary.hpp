// What summaries say of friction and heat beside the quantities of contacts: formulas and efficiency.
#pragma once

#include "input/case.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Formulas for friction and heating of a contact with a computed friction coefficient; empty without friction, and of
/// heat only what the oil's data allow.
Summary friction_predictions(const CaseInput& problem, const ContactSolids& solids, const ContactOperation& operation,
                             const SurfaceVelocities& velocities, double friction_coefficient);

/// beta [1/K] where the case gives none: an assumption, usual of mineral oils near 90 degrees Celsius.
constexpr double assumed_temperature_viscosity = 0.035;

/// L_T and thermal factors of the film, with the assumed fall of the viscosity where none is given.
Summary heating_predictions(const CaseInput& problem, const ContactSolids& solids, const ContactOperation& operation,
                            double slide_ratio);

/// Heating at the reference contact.
Summary heating_at_pitch(const CaseInput& problem);

/// Adds efficiency and mean friction coefficient to a summary that has the losses of whole mesh periods.
void add_efficiency(const MeshModel& mesh, Summary& summary);

}  // namespace gearfilm
