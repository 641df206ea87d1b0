// What is usual: steel gears of machines under mineral and synthetic oils, and the grids that resolve their films.
#include "input/plausibility.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "contact/line_contact.hpp"
#include "gear/tooth_space.hpp"
#include "gearfilm/error.hpp"
#include "input/case_numerics.hpp"
#include "input/case_roughness.hpp"

namespace gearfilm {
namespace {

using Oddities = std::vector<std::string>;

/// What is usual for one quantity, and what lies beyond.
struct Usual {
  std::string name;
  std::string unit;
  double lower;
  double upper;
  std::string if_below;
  std::string if_above;
};

std::string in_words(double value, const std::string& unit) {
  return worded(std::setprecision(4), value, (unit.empty() ? "" : " "), unit);
}

void compare(double value, const Usual& usual, Oddities& found) {
  const bool below = value < usual.lower;
  if (!below && !(value > usual.upper)) return;
  found.push_back(usual.name + " is " + in_words(value, usual.unit) + (below ? ", below " : ", above ") +
                  in_words(below ? usual.lower : usual.upper, usual.unit) + ": " +
                  (below ? usual.if_below : usual.if_above));
}

/// AvailableModels values, where they are given.
void compare_parameters(const ParameterValues& values, Oddities& found) {
  const auto modulus = [](const std::string& name) {
    return Usual{name,
                 "Pa",
                 50e9,
                 700e9,
                 "softer than the metals of gears; is it in Pa?",
                 "stiffer than tungsten carbide; is it in Pa?"};
  };
  for (Usual usual :
       {Usual{"lubricant.viscosity", "Pa s", 2e-3, 10, "thinner than oils in gears; water has 1e-3",
              "thicker than oils in gears; was it given in mPa s?"},
        Usual{"lubricant.pressure_viscosity", "1/Pa", 5e-9, 5e-8, "oils have 1e-8 to 3e-8", "oils have 1e-8 to 3e-8"},
        modulus("pinion.youngs_modulus"), modulus("wheel.youngs_modulus"), modulus("contact.youngs_modulus_1"),
        modulus("contact.youngs_modulus_2"), modulus("contact.reduced_modulus"),
        Usual{"gear.module", "m", 0.3e-3, 30e-3, "finer than gears of power transmissions",
              "coarser than all but the largest gears"},
        Usual{"contact.entrainment_velocity", "m/s", 0, 200, "", "faster than any gear runs"}}) {
    if (!values.has(usual.name)) continue;
    const double value = values.real(usual.name);
    usual.name = "'" + usual.name + "'";
    compare(value, usual, found);
  }
}

void compare_contact(const Scales& scales, Oddities& found) {
  compare(scales.hertz.pressure * 1e-9,
          {"the Hertz pressure", "GPa", 0.05, 4, "hardly a loaded contact; is the torque in N m, the force in N?",
           "more than hardened steel bears; is the torque in N m, the force in N?"},
          found);
  if (scales.solids.rough) return;
  compare(expected_central_film(scales.solids, scales.oil, scales.operation) * 1e6,
          {has_ellipse(scales.solids) ? "the central film by Nijenbanning, Venner and Moes"
                                      : "the central film of a line contact by Moes",
           "um", 0.02, 50, "thinner than the roughness of ground flanks", "thicker than films of loaded contacts"},
          found);
}

void compare_gears(const CaseInput& problem, Oddities& found) {
  const LineOfAction& line = *problem.pair.line;
  const double pitch_radius = line.base_radius_pinion() / std::cos(line.working_pressure_angle());
  compare(problem.pair.pinion_speed * largest_speed_ratio(problem.parameters) * pitch_radius,
          {"the pitch-line velocity", "m/s", 0, 200, "", "faster than any gear runs"}, found);
  compare(sum_of_profile_shifts(*problem.pair.gears),
          {"the sum of the profile shifts", "modules", -1.5, 3, "is gear.centre_distance that of these teeth?",
           "is gear.centre_distance that of these teeth?"},
          found);
  compare(line.contact_ratio(), {"the contact ratio", "", 1, 3, "", "spur gears have 1.2 to 2.5"}, found);
  if (!has_ellipse(problem.scales.solids)) return;
  compare(2e3 * problem.scales.hertz.b,
          {"the length of the contact ellipse", "mm", 0, 1e3 * problem.pair.gears->face_width, "",
           "longer than the face is wide; the load reaches the edges of the teeth"},
          found);
}

/// m_ge, and inertias that are given, beside those of two steel discs of the face width on the base circles.
void compare_mass(const CaseInput& problem, Oddities& found) {
  constexpr double steel = 7850.0;  // [kg/m^3]
  const std::array<double, 2> radii = {problem.pair.line->base_radius_pinion(), problem.pair.line->base_radius_wheel()};
  const auto disc = [&](double r) {
    return 0.5 * std::numbers::pi * steel * problem.pair.gears->face_width * r * r * r * r;
  };
  const std::array<const char*, 2> names = {"pinion.inertia", "wheel.inertia"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!problem.parameters.has(names[k])) continue;
    compare(problem.parameters.real(names[k]),
            {std::string("'").append(names[k]).append("'"), "kg m^2", disc(radii[k]) / 50, disc(radii[k]) * 50,
             "less than a fiftieth of that of a steel disc on the base circle",
             "more than 50 times that of a steel disc on the base circle; is it in kg m^2?"},
            found);
  }
  const double discs = equivalent_mass(*problem.pair.line, disc(radii[0]), disc(radii[1]));
  compare(*problem.pair.equivalent_mass,
          {"the equivalent mass", "kg", discs / 50, discs * 50,
           "less than a fiftieth of that of steel discs on the base circles",
           "more than 50 times that of steel discs on the base circles"},
          found);
}

void compare_teeth(const CaseInput& problem, Oddities& found) {
  const SpurGearPair& pair = *problem.pair.gears;
  const double m = pair.module_length;
  const auto in_modules = [&](const std::string& name, double largest, const std::string& question) {
    if (!problem.parameters.has(name)) return;
    compare(std::abs(problem.parameters.real(name)) / m, {"'" + name + "'", "modules", 0, largest, "", question},
            found);
  };
  in_modules("gear.backlash", 0.2, "more than gears have; is it in m?");
  for (const std::string gear : {"pinion.", "wheel."}) {
    in_modules(gear + "crowning", 0.2, "more than flanks are crowned; is it in m?");
    for (const char* key : {"tip_relief", "root_relief", "profile_slope", "profile_crowning"}) {
      in_modules(gear + key, 0.1, "more than flanks are modified by; is it in m?");
    }
  }
  const ToothSpace space = tooth_space(pair);
  if (space.implied_backlash) {
    compare(*space.implied_backlash / m,
            {"the backlash that both profile shifts imply at gear.centre_distance", "modules", -0.02, 0.2,
             "the teeth are thicker than the spaces of their mates", "is gear.centre_distance that of these teeth?"},
            found);
  }
  for (int k = 0; k < 2; ++k) {
    const std::string tips = k == 0 ? "pinion" : "wheel", roots = k == 0 ? "wheel" : "pinion";
    compare(space.tip_clearance[k] / m,
            {"the clearance between tips of the " + tips + " and assumed roots of the " + roots, "modules", 0, HUGE_VAL,
             "tips would dig into a root that a standard rack has cut; give " + roots + ".root_radius", ""},
            found);
  }
  compare(problem.pair.tooth_force * problem.pair.teeth.compliance(0.0) / m,
          {"the deflection of the teeth under the static force", "modules", 0, 0.1, "",
           "more than gears bear; are compliances in m/N?"},
          found);
}

/// Teeth whose foot the rack has cut away are computed as long as their active flank is whole.
void say_undercut(const CaseInput& problem, Oddities& found) {
  const std::string& kind = problem.parameters.text("gear.tooth_compliance");
  if (kind != "weber" && kind != "sainsot") return;
  const SpurGearPair& pair = *problem.pair.gears;
  const std::array<double, 2> shifts = profile_shifts(pair);
  for (int k = 0; k < 2; ++k) {
    const std::string name = k == 0 ? "pinion" : "wheel";
    const ToothProfile profile(k == 0 ? pair.pinion : pair.wheel, pair, shifts[k], name);
    if (!profile.undercut()) continue;
    found.push_back("the rack undercuts the teeth of the " + name + ": their involute begins " +
                    in_words(1e6 * (profile.form_radius() - profile.base_radius()), "um") +
                    " above the base circle, below the active flank, which is whole");
  }
}

void say_tilt(const CaseInput& problem, Oddities& found) {
  constexpr double tolerable = 0.05;  // of the face width, that rows of a dry contact may have lost without a tilt too
  if (!problem.pair.tilt) return;
  const ShaftTilt& tilt = *problem.pair.tilt;
  if (tilt.loaded_without_tilt - tilt.loaded_width < tolerable * problem.pair.gears->face_width) return;
  found.push_back("the static force tilts the shafts until the flanks touch over " +
                  in_words(1e3 * tilt.loaded_width, "mm") + " of the face in the place of " +
                  in_words(1e3 * tilt.loaded_without_tilt, "mm") + ": one end carries nothing");
}

void say_load_model(const CaseInput& problem, Oddities& found) {
  if (problem.parameters.text("gear.load_model") == "point") return;
  found.push_back("'gear.load_model' is line_equivalent: the contact carries " +
                  in_words(problem.scales.operation.load, "N") + " in the place of the tooth's " +
                  in_words(problem.pair.tooth_force, "N") +
                  ", and its forces are of that; powers and heats are those of the whole tooth");
}

void compare_steps(const CaseInput& problem, Oddities& found) {
  constexpr double fewest_in_period = 30, fewest_in_swing = 30, most_in_march = 1e7;
  const double in_period = mesh_period(problem) / problem.numerics.steps.dT;
  compare(in_period,
          {"the number of time steps a mesh period", "", fewest_in_period, HUGE_VAL,
           "too coarse for entering and leaving contacts; lower time.dt", ""},
          found);
  if (swings(problem)) {
    compare(natural_period(problem) / problem.numerics.steps.dT,
            {"the number of time steps a free oscillation", "", fewest_in_swing * (1 - 1e-9), HUGE_VAL,
             "too coarse for the vibration of the pair; lower time.dt", ""},
            found);
  }
  compare(in_period * problem.march.mesh_periods,
          {"the number of time steps of a march", "", 0, most_in_march, "",
           "days of computing; raise time.dt or lower mesh_periods"},
          found);
}

void compare_grid(const CaseInput& problem, Oddities& found) {
  const Steps steps = steps_of(problem.numerics);
  compare(pressure_length(ExpectedFilm(problem.scales)) / steps.x,
          {"the number of nodes along the half-axis a or, where it is longer, the inlet's rise of pressure", "", 3,
           HUGE_VAL, "too coarse for a film; raise grid.nx", ""},
          found);
  if (problem.numerics.face_rows) {
    for (const std::string name : {"grid.ny", "grid.y_half"}) {
      if (problem.parameters.has(name)) {
        found.push_back("'" + name + "' is given, but films over the whole face have rows of their own; give " +
                        "grid.first_row, grid.row_growth or grid.largest_row instead");
      }
    }
  }
  if (steps.y == 0.0) return;  // rows are graded, or single
  compare(1.0 / steps.y,
          {"the number of nodes along the half-axis b", "", 3, HUGE_VAL, "too coarse for a film; raise grid.ny", ""},
          found);
}

}  // namespace

std::vector<std::string> plausibility_warnings(const CaseInput& problem) {
  Oddities found = roughness_warnings(problem.parameters);
  compare_parameters(problem.parameters, found);
  compare_contact(problem.scales, found);
  if (problem.kind == CaseKind::gear_pair) {
    say_load_model(problem, found);
    say_tilt(problem, found);
    compare_gears(problem, found);
    compare_teeth(problem, found);
    say_undercut(problem, found);
    if (problem.pair.equivalent_mass) compare_mass(problem, found);
    compare_steps(problem, found);
  }
  compare_grid(problem, found);
  return found;
}

}  // namespace gearfilm
