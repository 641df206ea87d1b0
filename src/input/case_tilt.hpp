// The face of a pair whose shafts tilt under load (mesh/shaft_tilt.hpp).
#pragma once

#include <memory>

#include "input/case.hpp"

namespace gearfilm {

/// The face of the pair, with the slope that the static force gives it where a gear is on two bearings at a distance;
/// what these do goes into the pair. Throws InputError where the face, or the tilt, is impossible.
std::shared_ptr<const Face> face_under_load(const ParameterValues& values, PairCase& pair, ContactSolids solids,
                                            const Lubricant& oil);

}  // namespace gearfilm
