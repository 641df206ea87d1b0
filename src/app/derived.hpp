// What every command says about its case: derived quantities in the summary, identity in the results file.
#pragma once

#include "gearfilm/input/case.hpp"
#include "output/results_file.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Geometry, Hertz contact, Moes groups, frequencies; what a case has no data for is left out.
Summary derived_quantities(const Case& problem);

/// Film formulas for solids under an operation, [m]; keys hamrock_dowson_h_central etc.
Summary film_predictions(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);

/// Program, provenance, command and all parameters as attributes of a results file.
void write_identity(ResultsFile& file, const Case& problem, const std::string& command);

}  // namespace gearfilm
