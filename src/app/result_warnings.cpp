#include "app/result_warnings.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "input/case_stress.hpp"
#include "output/screen.hpp"
#include "results/friction_summary.hpp"

namespace gearfilm {
namespace {

// Where the viscosity of oils has been measured, roughly: an assumption.
constexpr double hottest_oil = 473.0;           // [K]
constexpr double largest_sound_pressure = 4e9;  // [Pa]
constexpr double tolerable_heating = 0.8;       // factor of the film
constexpr double tolerable_missing = 0.01;      // part of the nodes

const auto three_digits = std::setprecision(3);

/// The value under the first of the names that a summary has.
std::optional<double> value_of(const Summary& summary, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (summary.contains(name) && summary[name].is_number()) return summary[name].get<double>();
  }
  return {};
}

}  // namespace

void warn_of_heating(MPI_Comm comm, const CaseInput& problem, const Summary& heating) {
  if (problem.traction && problem.traction->heats_film()) return;
  if (problem.parameters.given("thermal.model") && !problem.traction) return;
  const std::optional<double> factor = value_of(heating, {"murch_wilson_thermal_factor"});
  if (!factor || *factor >= tolerable_heating) return;
  std::string assumed;
  if (!problem.thermal_oil) {
    assumed = worded(", with an assumed lubricant.temperature_viscosity of ", assumed_temperature_viscosity,
                     " 1/K, since none is given");
  }
  warn(comm, three_digits,
       "the film is computed as if its inlet were not heated by shear, which may make it thinner by ",
       100.0 * (1.0 - *factor), " % (by Murch and Wilson's factor ", *factor, assumed,
       "); thermal.model film, with friction.law and lubricant.temperature_viscosity, computes it");
}

void warn_of_validity(MPI_Comm comm, const CaseInput& problem, const Summary& summary) {
  const auto pressure = value_of(summary, {"p_hertz_max", "p_hertz"});
  const auto yielding = first_yield_pressure(problem.parameters, problem.scales);
  if (pressure && yielding && *pressure > *yielding) {
    warn(comm, three_digits, "a gear of this yield stress yields below its surface from a Hertz pressure of ",
         1e-9 * *yielding, " GPa on, and the largest is ", 1e-9 * *pressure,
         " GPa: stresses are those of elastic bodies");
  }
  if (pressure && *pressure > largest_sound_pressure) {
    warn(comm, three_digits, "the largest Hertz pressure is ", 1e-9 * *pressure, " GPa, above ",
         1e-9 * largest_sound_pressure, " GPa: more than hardened steel bears");
  }
  const auto temperature = value_of(summary, {"film_temperature_max"});
  if (temperature && *temperature > hottest_oil) {
    warn(comm, three_digits, "the film is as hot as ", *temperature, " K in places: above ", hottest_oil,
         " K the oil's law of viscosity is extrapolated, and oils decompose");
  }
  const auto ratio = value_of(summary, {"lambda_min", "lambda"});
  const bool modelled = value_of(summary, {"asperity_load_share_max", "asperity_load_share"}).has_value();
  if (ratio && *ratio < 1.0 && !modelled) {
    warn(comm, three_digits, "the smallest film is ", *ratio,
         " of the roughness: asperities touch, which is not modelled; roughness.model stochastic does");
  }
  const auto missed = value_of(summary, {"temperatures_missed_max", "temperatures_missed"});
  if (missed && *missed > tolerable_missing) {
    warn(comm, three_digits, "in ", 100.0 * *missed,
         " % of a contact's nodes the temperature across the film did not settle; raise thermal.points");
  }
}

double tolerable_error(const CaseInput& problem) {
  constexpr double usual = 0.05;
  const std::string accuracy = "grid.accuracy";
  return problem.parameters.given(accuracy) ? std::max(usual, problem.parameters.real(accuracy)) : usual;
}

void note_spike(MPI_Comm comm, const Summary& summary) {
  if (!summary.contains("p_max_error") || summary["p_max_error"].is_null()) return;
  if (!summary["p_max_extrapolated"].is_null()) return;
  say(comm,
      "the largest pressure is, or may become on finer grids, that of the outlet's spike, whose limit is not known: "
      "its error is what doubling the nodes twice may add");
}

}  // namespace gearfilm
