// Roughness of the surfaces of a case.
#pragma once

#include <memory>
#include <optional>

#include "input/parameter_values.hpp"
#include "roughness/archard.hpp"
#include "roughness/rough_surfaces.hpp"

namespace gearfilm {

/// sqrt(Rq_1^2 + Rq_2^2) [m]; absent where neither surface has a roughness.
std::optional<double> read_roughness(const ParameterValues& values);

/// Rough surfaces that films see; null without roughness.model. Throws InputError.
std::shared_ptr<const RoughSurfaces> read_rough_surfaces(const ParameterValues& values, double reduced_modulus);

/// Absent without coefficients. Throws InputError where no asperities are computed that could wear.
std::optional<WearCoefficients> read_wear(const ParameterValues& values);

}  // namespace gearfilm
