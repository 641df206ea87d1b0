#include "input/case_teeth.hpp"

#include <cmath>
#include <numbers>

#include "gearfilm/error.hpp"
#include "input/point_table.hpp"

namespace gearfilm {
namespace {

ReliefShape shape_named(const std::string& name) {
  if (name == "linear") return ReliefShape::linear;
  return name == "smooth" ? ReliefShape::smooth : ReliefShape::parabolic;
}

/// L, given as it is, or by the radius or the roll angle at which the relief begins; tip: radius of curvature there.
double tip_relief_length(const ParameterValues& values, const std::string& gear, double tip, double base_radius) {
  const std::string relief = gear + ".tip_relief", length = relief + "_length";
  const std::string radius = relief + "_start_radius", roll = relief + "_start_roll_deg";
  std::vector<std::string> given;
  for (const std::string& name : {length, radius, roll}) {
    if (values.has(name)) given.push_back(name);
  }
  if (given.size() > 1) {
    throw InputError(values.origin(given[1]) + ": both '" + given[0] + "' and '" + given[1] +
                     "' are given, and each says where the relief begins; delete one");
  }
  if (values.real(relief) == 0.0) return 0.0;
  if (given.empty()) {
    values.refuse(relief, "is given without its length; give '" + length + "', '" + radius + "' or '" + roll + "'");
  }
  if (given[0] == length) return values.real(length);
  if (given[0] == roll) return tip - values.real(roll) * std::numbers::pi / 180.0 * base_radius;
  const double start = values.real(radius);
  return tip - std::sqrt(std::max(0.0, start * start - base_radius * base_radius));
}

double root_relief_length(const ParameterValues& values, const std::string& gear) {
  const std::string relief = gear + ".root_relief", length = relief + "_length";
  if (values.real(relief) == 0.0) return 0.0;
  if (values.has(length)) return values.real(length);
  values.refuse(relief, "is given without its length; give '" + length + "'");
}

std::vector<double> read_pitch_errors(const ParameterValues& values, const std::string& gear) {
  constexpr double largest = 0.01;
  const std::string list = gear + ".pitch_errors", file = gear + ".pitch_errors_file", what = "error of a pitch in m";
  if (values.has(list) && values.has(file)) {
    throw InputError(values.origin(file) + ": both '" + list + "' and '" + file +
                     "' are given, and each holds the errors; delete one");
  }
  if (values.has(file)) return read_numbers_in_file(values, file, -largest, largest, what);
  if (!values.has(list)) return {};
  return read_numbers(values, list, -largest, largest, what);
}

GearFlanks read_flanks(const ParameterValues& values, const std::string& gear, double tip, double base_radius) {
  GearFlanks flanks;
  flanks.modification = {.tip = {values.real(gear + ".tip_relief"), tip_relief_length(values, gear, tip, base_radius),
                                 shape_named(values.text(gear + ".tip_relief_shape"))},
                         .root = {values.real(gear + ".root_relief"), root_relief_length(values, gear),
                                  shape_named(values.text(gear + ".root_relief_shape"))},
                         .slope = values.real(gear + ".profile_slope"),
                         .crowning = values.real(gear + ".profile_crowning"),
                         .curves = {}};
  if (values.has(gear + ".profile_file")) {
    flanks.modification.curves.push_back(read_ascending_points(
        values, gear + ".profile_file",
        "a point of the profile; give two numbers, radius of curvature [m] and material removed [m]"));
  }
  flanks.pitch_errors = read_pitch_errors(values, gear);
  return flanks;
}

ComplianceOptions read_compliance(const ParameterValues& values) {
  const std::string kind = "gear.tooth_compliance", file = "gear.compliance_file";
  ComplianceOptions options{.teeth = {},
                            .table = {},
                            .factor = values.real("gear.compliance_factor"),
                            .mesh = values.real("gear.mesh_compliance"),
                            .body_coupling = values.yes("gear.body_coupling")};
  if (values.text(kind) == "weber") options.teeth = FoundationModel::weber;
  if (values.text(kind) == "sainsot") options.teeth = FoundationModel::sainsot;
  if (values.text(kind) != "table") return options;
  if (!values.has(file)) {
    values.refuse(kind, "is table, but '" + file + "' is missing; give the file");
  }
  options.table = read_ascending_points(
      values, file,
      "a point of the compliance; give two numbers, position [m] and compliance of a pair of teeth [m/N]");
  for (const auto& [position, compliance] : options.table) {
    if (compliance > 0.0) continue;
    throw InputError(values.text(file) + ": the compliance at " + format_value(position) + " m is " +
                     format_value(compliance) + " m/N; give positive ones");
  }
  return options;
}

}  // namespace

Teeth read_teeth(const ParameterValues& values, const SpurGearPair& pair, const LineOfAction& line,
                 const WornFlanks& worn) {
  std::array<GearFlanks, 2> flanks = {
      read_flanks(values, "pinion", line.radius_pinion(line.exit()), line.base_radius_pinion()),
      read_flanks(values, "wheel", line.radius_wheel(line.entry()), line.base_radius_wheel())};
  for (std::size_t gear = 0; gear < flanks.size(); ++gear) {
    const auto& [y, removed] = worn.flanks[gear];
    if (removed.empty()) continue;
    flanks[gear].modification.curves.push_back(removed[removed.size() / 2]);
    flanks[gear].beside_middle = UnevenFlank(y, removed);
  }
  const bool field = values.text("gear.profile_local") == "field";
  return {pair, line, std::move(flanks), read_compliance(values), field ? ProfileAction::field : ProfileAction::offset};
}

}  // namespace gearfilm
