#include "input/case_roughness.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "gearfilm/error.hpp"
#include "input/point_table.hpp"

namespace gearfilm {
namespace {

bool bare(const ParameterValues& values) { return values.text("case.kind") != "gear_pair"; }

/// Rq of both bodies [m]; absent where it is not known.
std::array<std::optional<double>, 2> read_root_mean_squares(const ParameterValues& values,
                                                            const FlankTopography& topography) {
  const std::array<std::string, 2> squares = values.body_keys("roughness"), means = values.body_keys("roughness_ra");
  std::array<std::optional<double>, 2> result = topography.shorter;
  for (std::size_t k = 0; k < result.size(); ++k) {
    values.require_not_both(squares[k], means[k], "; delete one");
    for (const std::string& key : {squares[k], means[k]}) {
      if (result[k] && values.has(key))
        values.refuse(key, "is given, but the flank's surface is measured and says how rough it is; delete one");
    }
    if (values.has(squares[k])) result[k] = values.real(squares[k]);
    // Rq = (pi/2)^(1/2) Ra holds for Gaussian heights.
    if (values.has(means[k])) result[k] = std::sqrt(0.5 * std::numbers::pi) * values.real(means[k]);
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
