// Viscosity by the free volume that Tait's equation of state leaves, Doolittle's law: as X. Liu, T. Long, X. Li, F.
// Guo, Frontiers in Manufacturing Technology 2 (2023) 1029860 (doi 10.3389/fmtec.2022.1029860), eq. (20), have it at
// one temperature, and with temperature as it is used since Bair's book on high-pressure rheology (not looked up):
//   ln eta = const + B R_0 w/f,  f = V/V_R - R_0 w,  w = 1 + eps_c (T - T_R)
// The constants are those of squalane, pressure by Table 1 of the article, temperature as in input/squalane.yaml.
#pragma once

#include "gearfilm/error.hpp"
#include "lubricant/tait.hpp"
#include "lubricant/viscosity_law.hpp"

namespace gearfilm {

struct Doolittle {
  static constexpr std::string_view name = "doolittle", meaning = "by the free volume of Tait's law";
  static constexpr bool takes_coefficients = false;

  Tait tait{};
  double factor = 5.258;        ///< B
  double R0 = 0.6633;           ///< R_0, occupied volume over V_R
  double expansion = -5.66e-4;  ///< eps_c [1/K]

  template <class Each>
  void each_constant(Each&& each) {
    tait.each_constant(each);
    each(factor, OilConstant{"doolittle_factor", "B", "-", 0.0, 50.0, true, "doolittle: factor"});
    each(R0, formerly("doolittle_occupied",
                      {"doolittle_r0", "R_0", "-", 0.05, 0.99, true, "doolittle: occupied volume over V_R"}));
    each(expansion, OilConstant{"doolittle_expansion", "eps_c", "1/K", -0.01, 0.01, false,
                                "doolittle: occupied volume over that at T_R, 1 + eps_c (T - T_R)", 0.0});
  }

  void check(const AmbientOil& oil) const {
    const double above = oil.temperature - tait.reference_temperature;
    if (tait.volume(0.0, above).value - R0 * (1.0 + expansion * above) > 0.0) return;
    throw InputError("lubricant_doolittle_r0 = " + shown(R0) + " leaves no free volume at " + shown(oil.temperature) +
                     " K: give R_0 below 1, and temperatures in K");
  }

  /// B R_0 w/f at p and T. Where the free volume is nearly gone it goes on along its tangent.
  StateFunction log_viscosity(double pressure, double temperature) const {
    const double above = temperature - tait.reference_temperature;
    const StateFunction volume = tait.volume(pressure, above);
    const double w = 1.0 + expansion * above, free = volume.value - R0 * w;
    constexpr double most = 120.0;  // ln eta of a glass
    const double least = factor * R0 / most, kept = free > least ? free : least;
    const double inverse = 1.0 / kept, width = factor * R0 * w;
    const double value = width * (inverse + (kept - free) * inverse * inverse);
    const double slope = -width * inverse * inverse;                       // by f
    const double curvature = free > least ? -2.0 * slope * inverse : 0.0;  // by f twice
    const double free_by_temperature = volume.by_temperature - R0 * expansion;
    return {value, slope * volume.by_pressure, slope * free_by_temperature + expansion / w * value,
            curvature * volume.by_pressure * free_by_temperature + slope * volume.by_both +
                expansion / w * slope * volume.by_pressure};
  }

  using Evaluator = StateEvaluator<Doolittle>;
};

}  // namespace gearfilm
