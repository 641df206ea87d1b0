// Tait's equation of state, as X. Liu, T. Long, X. Li, F. Guo, Frontiers in Manufacturing Technology 2 (2023) 1029860
// (doi 10.3389/fmtec.2022.1029860), eq. (19), have it at one temperature, and with temperature as it is used since
// Bair's book on high-pressure rheology (not looked up):
//   V/V_R = [1 + a_v (T - T_R)] {1 - ln[1 + (1 + K') p/K]/(1 + K')},  K = K_R exp[-beta_K (T - T_R)]
// The constants are those of squalane, pressure by Table 1 of the article, temperature as in input/squalane.yaml.
#pragma once

#include "lubricant/density_law.hpp"
#include "lubricant/vector_math.hpp"

namespace gearfilm {

struct Tait {
  static constexpr std::string_view name = "tait";
  static constexpr bool takes_expansion = false;

  double reference_temperature = 298.0;  ///< T_R [K]
  double modulus = 1.312e9;              ///< K_R [Pa]
  double K0_prime = 11.74;               ///< K'
  double beta_K = 5.457e-3;              ///< beta_K [1/K]
  double expansion = 8.123e-4;           ///< a_v [1/K]

  template <class Each>
  void each_constant(Each&& each) {
    each(reference_temperature,
         OilConstant{"reference_temperature", "T_R", "K", 150.0, 800.0, false,
                     "at which the constants of tait and doolittle hold", "thermal.temperature"});
    each(modulus, OilConstant{"tait_modulus", "K_R", "Pa", 1e7, 1e12, false, "tait: isothermal bulk modulus at T_R"});
    each(K0_prime,
         formerly("tait_slope", {"tait_k0_prime", "K'", "-", 1.0, 50.0, true, "tait: its derivative by pressure"}));
    each(beta_K, formerly("tait_softening", {"tait_beta_k", "beta_K", "1/K", 0.0, 0.1, false,
                                             "tait: K = K_R exp[-beta_K (T - T_R)]", 0.0}));
    each(expansion,
         OilConstant{"tait_expansion", "a_v", "1/K", 0.0, 0.01, false, "tait: V/V_R = 1 + a_v (T - T_R)", 0.0});
  }

  /// V/V_R at a pressure and at T - T_R.
  StateFunction volume(double pressure, double above) const {
    const double p = pressure > 0.0 ? pressure : 0.0, on = pressure < 0.0 ? 0.0 : 1.0, c = 1.0 + K0_prime;
    const double K = modulus * exp(-beta_K * above), ratio = c * p / K;
    const double warm = 1.0 + expansion * above, pressed = 1.0 - log1p(ratio) / c;
    return {warm * pressed, -on * warm / (K * (1.0 + ratio)),
            expansion * pressed - warm * beta_K * ratio / ((1.0 + ratio) * c),
            -on * (expansion + warm * beta_K / (1.0 + ratio)) / (K * (1.0 + ratio))};
  }

  double expanded(double pressure, double T_0, double temperature) const {
    const auto at = [&](double T) { return volume(pressure, T - reference_temperature).value; };
    return at(T_0) / at(temperature);
  }

  class Evaluator;
};

class Tait::Evaluator {
public:
  Evaluator(const Tait& law, double T_0)
      : law_(law), above_(T_0 - law.reference_temperature), ambient_volume_(law.volume(0.0, above_).value) {}

  PressureFunction density(double pressure) const {
    const StateFunction volume = law_.volume(pressure, above_);
    const double rho = ambient_volume_ / volume.value;
    return {rho, -rho / volume.value * volume.by_pressure};
  }

private:
  Tait law_;
  double above_;           // T_0 - T_R
  double ambient_volume_;  // V/V_R at T_0
};

}  // namespace gearfilm
