// What a law of density is: rho/rho_0 over pressure, with its constants, and how it falls with temperature. As with the
// laws of viscosity (viscosity_law.hpp) a law is a struct of its constants, and its Evaluator has them at hand for one
// oil. Below p = 0 it is constant. Pressures in [Pa], temperatures in [K].
#pragma once

#include <concepts>

#include "lubricant/oil_law.hpp"

namespace gearfilm {

template <class Evaluator>
concept EvaluatesDensity = requires(const Evaluator rho, double p) {
  { rho.density(p) } -> std::same_as<PressureFunction>;  // rho(p, T_0)/rho(0, T_0)
};

/// A law that does not take the coefficient of expansion beta_rho has one of its own.
template <class Law>
concept ExpandsByItself = requires(const Law law, double p, double T_0, double T) {
  { law.expanded(p, T_0, T) } -> std::same_as<double>;  // rho(p, T)/rho(p, T_0)
};

template <class Law>
concept DensityLaw = requires(Law law, void (*each)(double&, const OilConstant&)) {
  { Law::name } -> std::convertible_to<std::string_view>;  // in case files
  { Law::takes_expansion } -> std::convertible_to<bool>;
  requires Law::takes_expansion || ExpandsByItself<Law>;
  law.each_constant(each);  // every constant with its description
  requires EvaluatesDensity<typename Law::Evaluator>;
  requires std::constructible_from<typename Law::Evaluator, const Law&, double>;  // at T_0
};

}  // namespace gearfilm
