#include "input/case_rating.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gear/tooth_profile.hpp"
#include "gearfilm/error.hpp"
#include "input/case_roughness.hpp"

namespace gearfilm {
namespace {

/// Ra of both flanks, their mean [m]; nothing unless both are known. Of Gaussian heights Ra = (2/pi)^(1/2) Rq.
std::optional<double> read_mean_roughness(const ParameterValues& values) {
  double sum = 0.0;
  for (std::size_t body : {0, 1}) {
    const std::optional<double> mean = values.real_if_given(values.body_keys("roughness_ra")[body]),
                                square = given_roughness(values, body);
    if (!square) return {};
    sum += mean ? *mean : *square * std::sqrt(2.0 / std::numbers::pi);
  }
  return sum > 0.0 ? std::optional(0.5 * sum) : std::nullopt;
}

RatingLimits read_limits(const ParameterValues& values) {
  return {
      .contact = values.real_if_given("rating.contact_limit"),
      .root = values.real_if_given("rating.root_limit"),
      .scuffing = values.real_if_given("rating.scuffing_temperature"),
      .integral = values.real_if_given("rating.integral_scuffing_temperature"),
      .film_ratio = values.real_if_given("rating.permissible_lambda"),
      .cycles = values.real("rating.cycles"),
      .oil_temperature = values.real_if_given("rating.oil_temperature").value_or(values.real("thermal.temperature")),
      .viscosity_40 = values.real_if_given("rating.viscosity_40"),
      .roughness_depth = values.real_if_given("rating.roughness_depth")};
}

/// What a limit is compared with must be computed.
void require_inputs(const CaseInput& problem, const RatingModel& model) {
  const ParameterValues& values = problem.parameters;
  for (const std::string key : {"rating.scuffing_temperature", "rating.integral_scuffing_temperature"}) {
    if (!values.has(key)) continue;
    if (!problem.traction) {
      values.refuse(key,
                    "is given, but no friction is computed that heats the flanks; choose friction.law, such as "
                    "eyring");
    }
    if (values.real(key) > model.limits.oil_temperature) continue;
    values.refuse(key, "is " + format_value(values.real(key)) + " K, not above the oil's " +
                           format_value(model.limits.oil_temperature) + " K; temperatures are in kelvin");
  }
  const std::string permissible = "rating.permissible_lambda";
  if (!values.has(permissible)) return;
  if (!model.mean_roughness) {
    values.refuse(permissible,
                  "is given, but not how rough both flanks are; give pinion.roughness_ra and "
                  "wheel.roughness_ra");
  }
}

}  // namespace

std::shared_ptr<const RatingModel> read_rating(const CaseInput& problem) {
  if (!problem.pair.line) return {};
  const ParameterValues& values = problem.parameters;
  const RatingLimits limits = read_limits(values);
  if (!limits.contact && !limits.root && !limits.scuffing && !limits.integral && !limits.film_ratio) {
    for (const char* key : {"rating.viscosity_40", "rating.roughness_depth", "rating.oil_temperature"}) {
      if (values.given(key))
        values.refuse(key, "is given, but no limit by which the pair is rated; give one of rating");
    }
    return {};
  }
  RatingModel model{.pair = *problem.pair.gears,
                    .line = *problem.pair.line,
                    .reduced_modulus = problem.scales.solids.reduced_modulus,
                    .pinion_speed = problem.pair.pinion_speed,
                    .limits = limits,
                    .oil = {problem.scales.oil.viscosity, problem.scales.oil.pressure_viscosity,
                            problem.scales.solids.reduced_modulus},
                    .mean_roughness = read_mean_roughness(values)};
  if (problem.traction) {
    const auto& bodies = problem.traction->bodies;
    model.bulk_temperature = std::max(bodies[0].temperature, bodies[1].temperature);
  }
  if (limits.root) {
    in_file_of(values, [&] {
      const auto [first, second] = profile_shifts(model.pair);
      model.roots = {ToothRoot(model.pair.pinion, model.pair, first), ToothRoot(model.pair.wheel, model.pair, second)};
    });
  }
  require_inputs(problem, model);
  return std::make_shared<const RatingModel>(model);
}

}  // namespace gearfilm
