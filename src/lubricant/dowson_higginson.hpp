// Density by Dowson and Higginson, Elasto-hydrodynamic Lubrication, Pergamon 1966; eq. (8) of
// doi 10.1016/j.triboint.2013.01.017:
//   rho/rho_0 = (A + 1.34 p)/(A + p),  A = 5.9e8 Pa
#pragma once

#include "lubricant/density_law.hpp"

namespace gearfilm {

struct DowsonHigginson {
  static constexpr std::string_view name = "dowson_higginson";
  static constexpr bool takes_expansion = true;

  template <class Each>
  static void each_constant(Each&&) {}

  class Evaluator {
  public:
    Evaluator(const DowsonHigginson&, double) {}

    static PressureFunction density(double pressure) {
      const double p = pressure > 0.0 ? pressure : 0.0, on = pressure < 0.0 ? 0.0 : 1.0, denominator = A + p;
      return {(A + limit * p) / denominator, on * ((limit - 1.0) * A) / (denominator * denominator)};
    }

  private:
    static constexpr double A = 5.9e8;     // [Pa]
    static constexpr double limit = 1.34;  // rho/rho_0 for p -> infinity
  };
};

}  // namespace gearfilm
