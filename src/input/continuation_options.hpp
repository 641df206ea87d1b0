// A continuation: which quantity of a gear pair is followed from where to where, by which steps.
#pragma once

#include <optional>
#include <string>

#include "input/parameter_values.hpp"
#include "orbits/continuation.hpp"

namespace gearfilm {

struct ContinuationCase {
  std::string parameter;       ///< the key that is varied
  std::string unit;            ///< its unit
  std::optional<double> from;  ///< absent where the case asks for no continuation
  double to = 0.0;
  ContinuationOptions options;

  bool upwards() const { return to > from.value_or(to); }
};

/// The usual steps: on films each point takes some marches, which have noise.
ContinuationOptions continuation_steps(bool on_films);

/// Throws InputError for ends that are given by half, equal, or none of the quantity's, and for steps that do not fit
/// together. order: of the first branch.
ContinuationCase read_continuation(const ParameterValues& values, int order);

}  // namespace gearfilm
