// The face of a contact: its ends, the shape of its gap, and the rows of the grid along it.
#pragma once

#include <memory>
#include <vector>

#include "contact/scales.hpp"
#include "dynamics/pair_numerics.hpp"
#include "input/parameter_values.hpp"

namespace gearfilm {

/// The face of a bare contact; null where no width of a face is given. Throws InputError where reliefs do not fit.
std::shared_ptr<const Face> read_face_of_contact(const ParameterValues& values);
/// The face of a gear pair. Throws InputError where reliefs or widths do not fit.
std::shared_ptr<const Face> read_face_of_pair(const ParameterValues& values);

/// Gives the solids the face, where their contact under a load reaches its ends or the kinks of its gap, or feels its
/// slope, or where the case asks for it: not where the ellipse lies well inside.
void set_face(const ParameterValues& values, const std::shared_ptr<const Face>& face, double load,
              ContactSolids& solids);

/// How rows along the face of such scales are graded. longest_by_waves: distance that resolves waves of the flanks [m].
RowGrading read_row_grading(const ParameterValues& values, const Scales& scales, FilmDiscretisation discretisation,
                            double longest_by_waves);

}  // namespace gearfilm
