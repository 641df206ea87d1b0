// What follows from a case without any field: the quantities of `info`.
#pragma once

#include "input/case.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Geometry, Hertz contact, Moes groups, frequencies; what a case has no data for is left out.
Summary derived_quantities(const CaseInput& problem);

/// The table of the manual, in Markdown.
std::string derived_markdown();
/// A line for each of these, for the screen.
std::vector<std::string> derived_lines(const Summary& quantities);

/// Film formulas for solids under an operation, [m]; keys hamrock_dowson_h_central etc.
Summary film_predictions(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);

}  // namespace gearfilm
