#include "input/case_roughness.hpp"

#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>

#include "gearfilm/error.hpp"
#include "input/plain_text.hpp"
#include "input/point_table.hpp"

namespace gearfilm {
namespace {

bool bare(const ParameterValues& values) { return values.text("case.kind") != "gear_pair"; }

/// Rz over Ra: 4 to 7 by a rule of thumb, here their geometric mean (an assumption).
constexpr double smallest_depth = 4.0, largest_depth = 7.0, usual_depth = 5.3;

/// Rq over Ra of Gaussian heights.
const double square_by_mean = std::sqrt(0.5 * std::numbers::pi);

std::array<std::string, 3> roughness_keys(const ParameterValues& values, std::size_t body) {
  return {values.body_keys("roughness")[body], values.body_keys("roughness_ra")[body],
          values.body_keys("roughness_rz")[body]};
}

/// Rq of both bodies [m]; absent where it is not known.
std::array<std::optional<double>, 2> read_root_mean_squares(const ParameterValues& values,
                                                            const FlankTopography& topography) {
  std::array<std::optional<double>, 2> result = topography.shorter;
  for (std::size_t k = 0; k < result.size(); ++k) {
    const auto keys = roughness_keys(values, k);
    values.require_not_both(keys[0], keys[1], "; delete one");
    values.require_not_both(keys[0], keys[2], "; delete one");
    values.require_not_both(keys[1], keys[2], "; delete one");
    for (const std::string& key : keys) {
      if (result[k] && values.has(key))
        values.refuse(key, "is given, but the flank's surface is measured and says how rough it is; delete one");
    }
    if (const auto given = given_roughness(values, k)) result[k] = given;
    if (result[k]) *result[k] *= topography.roughness_ratio;
  }
  return result;
}

AsperityLawKind asperity_law_named(const std::string& name) {
  if (name == "greenwood_tripp") return AsperityLawKind::greenwood_tripp;
  if (name == "greenwood_williamson") return AsperityLawKind::greenwood_williamson;
  if (name == "exponential") return AsperityLawKind::exponential;
  return name == "table" ? AsperityLawKind::table : AsperityLawKind::zhao_maietta_chang;
}

void read_table(const ParameterValues& values, AsperityOptions& options) {
  const std::string table = "roughness.table";
  if (!values.has(table)) {
    values.refuse("roughness.asperity_law",
                  "is table, but '" + table + "' is missing; give a file of gaps over sigma and pressures [Pa]");
  }
  for (const auto& [z, p] :
       read_ascending_points(values, table, "a gap over sigma and the pressure of the asperities [Pa]")) {
    if (!(p > 0.0) || (!options.table_p.empty() && p >= options.table_p.back())) {
      values.refuse(table, "has the pressure " + format_value(p) + " Pa at the gap " + format_value(z) +
                               "; pressures must be positive and fall as the gap grows");
    }
    options.table_z.push_back(z);
    options.table_p.push_back(p);
  }
}

AsperityOptions read_asperities(const ParameterValues& values) {
  AsperityOptions options{.kind = asperity_law_named(values.text("roughness.asperity_law")),
                          .density_product = values.real("roughness.asperity_density_product"),
                          .slope = values.real("roughness.asperity_slope"),
                          .hardness = values.real("roughness.hardness"),
                          .summit_shift = values.yes("roughness.summit_shift"),
                          .exponential_gap = values.real("roughness.exponential_gap")};
  if (options.kind == AsperityLawKind::exponential) {
    const std::string pressure = "roughness.exponential_pressure";
    if (!values.has(pressure)) {
      values.refuse("roughness.asperity_law",
                    "is exponential, but '" + pressure + "' is missing; give the pressure at no gap [Pa]");
    }
    options.exponential_pressure = values.real(pressure);
  }
  if (options.kind == AsperityLawKind::table) read_table(values, options);
  return options;
}

}  // namespace

std::optional<double> given_roughness(const ParameterValues& values, std::size_t body) {
  const auto [square, mean, depth] = roughness_keys(values, body);
  if (values.has(square)) return values.real(square);
  if (values.has(mean)) return square_by_mean * values.real(mean);
  if (values.has(depth)) return square_by_mean * values.real(depth) / usual_depth;
  return {};
}

std::vector<std::string> roughness_warnings(const ParameterValues& values) {
  std::vector<std::string> warnings;
  const auto in_um = [](double value) { return worded(std::setprecision(2), 1e6 * value); };
  for (std::size_t body : {0, 1}) {
    const std::string depth = roughness_keys(values, body)[2];
    if (!values.has(depth) || values.real(depth) == 0.0) continue;
    const double Rz = values.real(depth);
    warnings.push_back(in_quotes(depth) + " is " + in_um(Rz) +
                       " um, taken for Rq = " + in_um(square_by_mean * Rz / usual_depth) +
                       " um: Rz is from 4 to 7 times Ra, and Rq from " + in_um(square_by_mean * Rz / largest_depth) +
                       " to " + in_um(square_by_mean * Rz / smallest_depth) + " um; give " +
                       in_quotes(values.body_keys("roughness")[body]) + " or its Ra if they are known");
  }
  return warnings;
}

std::optional<double> read_roughness(const ParameterValues& values, const FlankTopography& topography) {
  const auto [first, second] = read_root_mean_squares(values, topography);
  const double both = std::hypot(first.value_or(0.0), second.value_or(0.0));
  return both > 0.0 ? std::optional(both) : std::nullopt;
}

std::shared_ptr<const RoughSurfaces> read_rough_surfaces(const ParameterValues& values,
                                                         const FlankTopography& topography, double reduced_modulus) {
  const std::string model = "roughness.model";
  if (bare(values) && values.text(model) != "none" && values.text(model) != "stochastic")
    values.refuse(model, "is " + values.text(model) + ", which follows flanks of a gear pair; set it to stochastic");
  if (!has_stochastic_roughness(values)) return {};
  if (!read_roughness(values, topography)) {
    values.refuse(model, "is " + values.text(model) + ", but neither surface has a roughness; give '" +
                             values.body_keys("roughness")[0] + "' or '" + values.body_keys("roughness")[1] + "'");
  }
  const auto [first, second] = read_root_mean_squares(values, topography);
  RoughOptions options{
      .roughness = {first.value_or(0.0), second.value_or(0.0)},
      .asperities = read_asperities(values),
      .mean_gap = values.text("roughness.mean_gap") == "nominal" ? MeanGap::nominal : MeanGap::gaussian};
  // The exponential law is one of the mean gap: the gap of the mean planes then stands for it.
  if (options.asperities.kind == AsperityLawKind::exponential) options.mean_gap = MeanGap::nominal;
  options.lay = bare(values) ? std::array{values.real("contact.lay"), values.real("contact.lay")}
                             : std::array{values.real("pinion.lay"), values.real("wheel.lay")};
  return std::make_shared<const RoughSurfaces>(options, reduced_modulus);
}

std::optional<WearCoefficients> read_wear(const ParameterValues& values) {
  const std::array<std::string, 2> keys = {"wear.coefficient_pinion", "wear.coefficient_wheel"};
  if (!values.has(keys[0]) && !values.has(keys[1])) return {};
  for (const std::string& key : keys) {
    if (values.has(key) && !has_stochastic_roughness(values)) {
      values.refuse(key, "is given, but no asperities are computed that could wear; set roughness.model to stochastic");
    }
  }
  return WearCoefficients{values.real_if_given(keys[0]).value_or(0.0), values.real_if_given(keys[1]).value_or(0.0)};
}

WearCase read_wearing(const ParameterValues& values, const std::optional<double>& roughness) {
  const std::string final_roughness = "wear.final_roughness", work = "wear.running_in_work";
  values.require_both(final_roughness, work, "give both, or neither");
  WearCase wearing{.cycles = values.real_if_given("wear.cycles"),
                   .largest_step = values.real("wear.largest_step"),
                   .points = values.integer("wear.points"),
                   .final_roughness = values.real_if_given(final_roughness),
                   .running_in_work = values.real_if_given(work)};
  if (wearing.final_roughness && roughness && !(*wearing.final_roughness < *roughness))
    values.refuse(final_roughness, "is " + format_value(*wearing.final_roughness) + " m, not below the roughness " +
                                       format_value(*roughness) + " m of both flanks together; give a smaller one");
  return wearing;
}

}  // namespace gearfilm
