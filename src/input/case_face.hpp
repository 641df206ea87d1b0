// The face of a contact: its ends, the shape of its gap, and the rows of the grid along it.
#pragma once

#include <memory>
#include <vector>

#include "contact/scales.hpp"
#include "dynamics/pair_numerics.hpp"
#include "input/parameter_values.hpp"

namespace gearfilm {

/// Of a bare contact; null where no width of a face is given. Throws InputError where reliefs do not fit.
std::shared_ptr<const Face> read_face_of_contact(const ParameterValues& values);

/// Whether the contact of these solids under a load reaches the ends of a face or the kinks of its gap, or feels its
/// slope: not where its ellipse lies well inside.
bool reaches_ends(const Face& face, const ContactSolids& solids, double load);

/// How rows along it are graded.
RowGrading read_row_grading(const ParameterValues& values, const Face& face);

}  // namespace gearfilm
