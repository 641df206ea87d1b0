// The dry pressure along a whole face, or of a line contact, as a first guess of films.
#pragma once

#include <span>
#include <vector>

#include "film/contact_conditions.hpp"
#include "film/discretisation.hpp"

namespace gearfilm {

/// The largest half-width of a row [a]; of a line contact its half-width.
double largest_half_width(const Scales& scales, const ContactConditions& conditions, double pressure_integral);

/// The pressure of row_contact.hpp under a pressure integral on the own nodes, zero on the boundary; compact. Returns
/// the approach, from gap zero in the middle of the face; zero of a line contact, which has none. Throws SolveError.
double face_pressure(Discretisation& discretisation, const Scales& scales, const ContactConditions& conditions,
                     double pressure_integral, std::span<double> pressure);

/// Compact pressures of a film along a whole face after its force has changed from one pressure integral to another:
/// row by row, with the dry half-widths s and s', P'(X) = s'/s P(X s/s'). Rows that had no load get the dry pressure.
/// Throws SolveError.
std::vector<double> rescaled_face_pressure(Discretisation& discretisation, const Scales& scales,
                                           const ContactConditions& conditions, double before, double after,
                                           std::span<const double> pressure);

}  // namespace gearfilm
