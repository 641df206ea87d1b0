// Density that pressure does not change.
#pragma once

#include "lubricant/density_law.hpp"

namespace gearfilm {

struct Incompressible {
  static constexpr std::string_view name = "incompressible";
  static constexpr bool takes_expansion = true;

  template <class Each>
  static void each_constant(Each&&) {}

  struct Evaluator {
    Evaluator(const Incompressible&, double) {}
    static PressureFunction density(double) { return {1.0, 0.0}; }
  };
};

}  // namespace gearfilm
