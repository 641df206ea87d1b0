// Roughness of the surfaces of a case.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/case.hpp"
#include "input/case_topography.hpp"
#include "input/parameter_values.hpp"
#include "roughness/archard.hpp"
#include "roughness/rough_surfaces.hpp"

namespace gearfilm {

/// Rq of a body from Rq, Ra or Rz, whichever is given [m].
std::optional<double> given_roughness(const ParameterValues& values, std::size_t body);

/// How uncertain Rq is where Rz stands for it.
std::vector<std::string> roughness_warnings(const ParameterValues& values);

/// sqrt(Rq_1^2 + Rq_2^2) [m], of measured flanks what is shorter than the cutoff; absent where neither surface has a
/// roughness.
std::optional<double> read_roughness(const ParameterValues& values, const FlankTopography& topography);

/// Rough surfaces that films see; null without roughness.model. Throws InputError.
std::shared_ptr<const RoughSurfaces> read_rough_surfaces(const ParameterValues& values,
                                                         const FlankTopography& topography, double reduced_modulus);

/// Absent without coefficients. Throws InputError where no asperities are computed that could wear.
std::optional<WearCoefficients> read_wear(const ParameterValues& values);

/// How flanks are worn step by step. Throws InputError.
WearCase read_wearing(const ParameterValues& values, const std::optional<double>& roughness);

}  // namespace gearfilm
