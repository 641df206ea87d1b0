// An oil: its laws of density and of viscosity, each in a header of its own, and what follows from them. Pressures in
// [Pa], temperatures in [K].
#pragma once

#include "lubricant/barus.hpp"
#include "lubricant/doolittle.hpp"
#include "lubricant/dowson_higginson.hpp"
#include "lubricant/incompressible.hpp"
#include "lubricant/roelands.hpp"
#include "lubricant/tait.hpp"
#include "lubricant/yasutomi.hpp"

namespace gearfilm {

/// All laws there are. A new one is a name here; the first is the default.
using AnyViscosityLaw = std::variant<Roelands, Barus, Doolittle, Yasutomi>;
using AnyDensityLaw = std::variant<DowsonHigginson, Incompressible, Tait>;

/// An isothermal piezoviscous compressible oil.
struct Lubricant {
  double viscosity = 0.0;           ///< ambient viscosity eta_0 [Pa s]
  double pressure_viscosity = 0.0;  ///< alpha_B [1/Pa]; of a law that does not take it alpha* (isoviscous_coefficient)
  AnyViscosityLaw viscosity_law{};
  AnyDensityLaw density_law{};
  double temperature = 363.15;  ///< T_0, at which all this holds [K]
};

/// Whether the law of viscosity takes alpha_B and beta; else they follow from it.
bool takes_coefficients(const Lubricant& oil);

/// Throws InputError unless eta_0 is positive, alpha_B where the law takes it, and the law finds a liquid at T_0 and
/// ambient pressure.
void check(const Lubricant& oil);

/// The laws of the oil, for loops. beta is zero.
using ViscosityEvaluator = EvaluatorOf<AnyViscosityLaw>;
using DensityEvaluator = EvaluatorOf<AnyDensityLaw>;
ViscosityEvaluator viscosity_evaluator(const Lubricant& oil);
ViscosityEvaluator viscosity_evaluator(const AnyViscosityLaw& law, const AmbientOil& oil);
DensityEvaluator density_evaluator(const Lubricant& oil);

PressureFunction relative_density(const Lubricant& oil, double pressure);
/// ln(eta/eta_0).
PressureFunction log_relative_viscosity(const Lubricant& oil, double pressure);

/// alpha* = 1/Int_0^inf eta_0/eta dp, the reciprocal asymptotic isoviscous pressure coefficient of the oil's law
/// [1/Pa].
double isoviscous_coefficient(const Lubricant& oil);

}  // namespace gearfilm
