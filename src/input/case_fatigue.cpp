#include "input/case_fatigue.hpp"

#include <array>

#include "gearfilm/error.hpp"
#include "input/point_table.hpp"

namespace gearfilm {
namespace {

DepthTable read_profile(const ParameterValues& values, const std::string& key, const std::string& what,
                        double deepest) {
  DepthTable table;
  for (const auto& [depth, value] : read_ascending_points(values, key, "a depth [m] and " + what)) {
    table.depth.push_back(depth);
    table.value.push_back(value);
  }
  if (table.depth.front() > 0.0) {
    values.refuse(key, "begins " + format_value(table.depth.front()) + " m below the surface; begin at a depth of 0");
  }
  if (table.deepest() < deepest) {
    values.refuse(key, "ends at a depth of " + format_value(table.deepest()) +
                           " m, but stresses are computed down to " + format_value(deepest) +
                           " m; measure deeper, or lower stress.depth_max");
  }
  return table;
}

DepthTable read_hardness_table(const ParameterValues& values, const std::string& key, double deepest) {
  DepthTable table = read_profile(values, key, "the hardness there [HV]", deepest);
  for (const double hardness : table.value) {
    if (hardness >= 100.0 && hardness <= 1200.0) continue;
    values.refuse(key, "has a hardness of " + format_value(hardness) + " HV; give numbers in [100, 1200]");
  }
  return table;
}

/// By three numbers, all of them or none.
std::optional<CaseHardening> read_case_hardening(const ParameterValues& values, const std::string& gear) {
  const std::array<std::string, 3> keys = {gear + ".surface_hardness", gear + ".core_hardness", gear + ".case_depth"};
  for (const std::string& key : keys) {
    values.require_not_both(key, gear + ".hardness_file", ", and each says how hard the flank is; delete one");
    for (const std::string& other : keys) {
      values.require_both(key, other, "give surface_hardness, core_hardness and case_depth");
    }
  }
  if (!values.has(keys[0])) return {};
  const CaseHardening hardening{values.real(keys[0]), values.real(keys[1]), values.real(keys[2])};
  constexpr double at_case_depth = 550.0;
  if (!(hardening.surface > at_case_depth)) {
    values.refuse(keys[0], "is " + format_value(hardening.surface) +
                               " HV, not above the 550 HV at the case depth; give measured hardness as " + gear +
                               ".hardness_file");
  }
  if (!(hardening.core < at_case_depth)) {
    values.refuse(keys[1], "is " + format_value(hardening.core) +
                               " HV, not below the 550 HV at the case depth; give "
                               "measured hardness as " +
                               gear + ".hardness_file");
  }
  return hardening;
}

FlankMaterial read_flank_material(const ParameterValues& values, const std::string& gear, double deepest) {
  const std::string hardness = gear + ".hardness_file", kind = gear + ".residual_stress",
                    file = gear + ".residual_file";
  FlankMaterial flank{.hardening = read_case_hardening(values, gear)};
  if (values.has(hardness)) flank.hardness_table = read_hardness_table(values, hardness, deepest);
  if (values.text(kind) == "hardness") {
    if (!flank.has_hardness()) {
      values.refuse(kind, "is hardness, but none is known; give " + gear +
                              ".surface_hardness, core_hardness and "
                              "case_depth, or " +
                              hardness);
    }
    flank.residual_of_hardness = true;
  }
  if (values.text(kind) == "file") {
    if (!values.has(file))
      values.refuse(kind, "is file, but '" + file + "' is missing; give depths [m] and stresses [Pa]");
    flank.residual_table = read_profile(values, file, "the residual stress there [Pa]", deepest);
  } else if (values.has(file)) {
    values.refuse(file, "is given, but '" + kind + "' is " + values.text(kind) + "; set it to file");
  }
  return flank;
}

}  // namespace

std::optional<FatigueModel> read_fatigue(const ParameterValues& values, double deepest) {
  const std::string criterion = "fatigue.criterion", factor = "fatigue.shear_per_hardness";
  if (values.text("case.kind") != "gear_pair") return {};
  FatigueModel model{
      .dang_van = {.alpha = values.real("fatigue.alpha"), .compression_helps = values.yes("fatigue.compression")},
      .risk = {.stress_exponent = values.real("fatigue.stress_exponent"),
               .depth_exponent = values.real("fatigue.depth_exponent"),
               .weibull_slope = values.real("fatigue.weibull_slope"),
               .threshold = values.real("fatigue.threshold")},
      .flank_points = values.integer("fatigue.flank_points"),
      .margin = values.real("fatigue.margin"),
      .torsion_limit = values.real_if_given("fatigue.torsion_limit"),
      .shear_per_hardness = values.real(factor)};
  if (values.text(criterion) == "none") deepest = 0.0;
  model.material = {read_flank_material(values, "pinion", deepest), read_flank_material(values, "wheel", deepest)};
  if (values.text(criterion) == "none") return {};
  if (values.text("stress.model") == "none") {
    values.refuse(criterion, "is " + values.text(criterion) +
                                 ", but no stresses below films are computed; set stress.model to row");
  }
  if (!values.given(factor)) return model;
  if (model.torsion_limit) {
    values.refuse(factor, "and 'fatigue.torsion_limit' are both given, and each is the limit; delete one");
  }
  if (!model.material[0].has_hardness() && !model.material[1].has_hardness()) {
    values.refuse(factor,
                  "is given, but no hardness that makes a limit of it; give pinion.surface_hardness, "
                  "core_hardness and case_depth, or pinion.hardness_file");
  }
  return model;
}

}  // namespace gearfilm
