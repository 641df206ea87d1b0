// Heights of the flanks of a case that films follow node by node, and what of them is left to statistics.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "contact/scales.hpp"
#include "gear/line_of_action.hpp"
#include "input/parameter_values.hpp"
#include "roughness/topography.hpp"

namespace gearfilm {

struct FlankTopography {
  std::shared_ptr<const std::array<Topography, 2>> flanks{};  ///< null: none
  double shortest_along = HUGE_VAL;                           ///< wavelength to be resolved along the flank [m]
  double shortest_across = HUGE_VAL;                          ///< and across it [m]
  /// Root mean square of what is shorter than the cutoff on measured flanks [m].
  std::array<std::optional<double>, 2> shorter{};
  double roughness_ratio = 1.0;  ///< by which the statistics of worn flanks are less rough than those of the case
};

/// Whether asperities by statistics, and heights node by node, belong to the case.
bool has_stochastic_roughness(const ParameterValues& values);
bool has_deterministic_roughness(const ParameterValues& values);

/// Solids and operation are those of the reference contact between smooth flanks: its half-width sets the cutoff where
/// none is given, and waves are flattened as there. Throws InputError, also where heights are given that the model does
/// not follow.
FlankTopography read_topography(const ParameterValues& values, const std::optional<LineOfAction>& line,
                                const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);

}  // namespace gearfilm
