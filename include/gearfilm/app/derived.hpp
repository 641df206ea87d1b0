// Derived quantities of a case, as they appear in every summary.
#pragma once

#include "gearfilm/io/case.hpp"
#include "gearfilm/io/summary.hpp"

namespace gearfilm {

/// Geometry, Hertz contact, Moes groups, frequencies; what a case has no data for is left out.
Summary derived_quantities(const Case& problem);

/// Film formulas for solids under an operation, [m]; keys hamrock_dowson_central etc.
Summary film_predictions(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);

}  // namespace gearfilm
