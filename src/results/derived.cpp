#include "results/derived.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <span>

#include "contact/film_formulas.hpp"
#include "contact/line_contact.hpp"
#include "contact/mixed_formulas.hpp"
#include "contact/moes.hpp"
#include "gear/tooth_space.hpp"
#include "input/case_numerics.hpp"
#include "input/case_setup.hpp"
#include "mesh/static_mesh.hpp"
#include "results/friction_summary.hpp"
#include "results/members.hpp"

namespace gearfilm {
namespace {

/// What the quantities are computed from.
struct Derived {
  explicit Derived(const CaseInput& of)
      : problem(of),
        groups(moes_groups(scales.solids, scales.oil, scales.operation)),
        errors(expected_errors(numerics.discretisation, ExpectedFilm(scales), steps_of(numerics))),
        films(film_predictions(scales.solids, scales.oil, scales.operation)),
        heating(heating_at_pitch(of)) {
    if (!of.pair.line || of.parameters.text("gear.load_model") != "point") return;
    mesh = mesh_after_leaving(of);
    penetration = gearfilm::entry_penetration(*mesh, scales.static_force);
  }

  const CaseInput& problem;
  const Scales& scales = problem.scales;
  const PairNumerics& numerics = problem.numerics;
  MoesGroups groups;
  FilmErrors errors;
  Summary films;                        ///< by formulas
  Summary heating;                      ///< likewise
  std::optional<MeshModel> mesh{};      ///< of gears whose contact carries the force of the pair
  std::optional<double> penetration{};  ///< of an entering tooth [-]
};

double mesh_frequency_of(const CaseInput& problem) {
  return mesh_frequency(*problem.pair.gears, problem.pair.pinion_speed);
}

Summary if_finite(double value) { return std::isfinite(value) ? Summary(value) : absent(); }

template <class Value>
Summary of_line(const Derived& at, Value value) {
  return at.problem.pair.line ? Summary(std::invoke(value, *at.problem.pair.line)) : absent();
}

template <class Value>
Summary of_gears(const Derived& at, Value value) {
  return at.problem.pair.line ? Summary(value(at.problem)) : absent();
}

/// Of a pair with a mass.
template <class Value>
Summary of_mass(const Derived& at, Value value) {
  return at.mesh && at.problem.pair.equivalent_mass ? Summary(value(at, *at.problem.pair.equivalent_mass)) : absent();
}

constexpr auto gear_members = std::to_array<Member<Derived>>({
    {"case", "", "", "name of the case", [](const Derived& at) -> Summary { return at.problem.name; }},
    {"working_pressure_angle_deg", "alpha_w", "deg", "working pressure angle",
     [](const Derived& at) -> Summary {
       return of_line(
           at, [](const LineOfAction& line) { return line.working_pressure_angle() * 180.0 / std::numbers::pi; });
     }},
    {"base_radius_pinion", "r_b1", "m", "base radius of the pinion",
     [](const Derived& at) -> Summary { return of_line(at, &LineOfAction::base_radius_pinion); }},
    {"base_radius_wheel", "r_b2", "m", "base radius of the wheel",
     [](const Derived& at) -> Summary { return of_line(at, &LineOfAction::base_radius_wheel); }},
    {"base_pitch", "p_b", "m", "distance of two contacts on the line of action",
     [](const Derived& at) -> Summary { return of_line(at, &LineOfAction::base_pitch); }},
    {"xi_entry", "xi_a", "m", "where a contact enters, from the pitch point",
     [](const Derived& at) -> Summary { return of_line(at, &LineOfAction::entry); }},
    {"xi_exit", "xi_e", "m", "where a contact leaves, from the pitch point",
     [](const Derived& at) -> Summary { return of_line(at, &LineOfAction::exit); }},
    {"contact_ratio", "epsilon", "-", "contacts at a time, on the average",
     [](const Derived& at) -> Summary { return of_line(at, &LineOfAction::contact_ratio); }},
    {"implied_backlash", "j_n", "m", "normal backlash that both given profile shifts leave at the centre distance",
     [](const Derived& at) -> Summary {
       return at.problem.pair.gears ? if_there(tooth_space(*at.problem.pair.gears).implied_backlash) : absent();
     }},
});

constexpr auto contact_members = std::to_array<Member<Derived>>({
    {"R_x", "R_x", "m", "reduced radius in the direction of rolling, at the pitch point or of the bare contact",
     [](const Derived& at) -> Summary { return at.scales.solids.radius_x; }},
    {"R_y", "R_y", "m", "reduced radius along the face",
     [](const Derived& at) -> Summary { return if_finite(at.scales.solids.radius_y); }},
    {"E_prime", "E'", "Pa", "reduced modulus",
     [](const Derived& at) -> Summary { return at.scales.solids.reduced_modulus; }},
    {"load", "w*", "N", "static force along the line of action, or the point load that stands for it",
     [](const Derived& at) -> Summary { return at.scales.operation.load; }},
    {"tooth_force", "", "N", "static force along the line of action",
     [](const Derived& at) -> Summary {
       return at.problem.pair.line ? Summary(at.problem.pair.tooth_force) : absent();
     }},
    {"entrainment_velocity", "u_m", "m/s", "mean of the velocities of both flanks",
     [](const Derived& at) -> Summary { return at.scales.operation.entrainment_velocity; }},
    {"kappa", "kappa", "-", "ratio of the half axes a/b of the Hertz ellipse",
     [](const Derived& at) -> Summary { return at.scales.hertz.ellipticity; }},
    {"a", "a", "m", "half axis of the ellipse in the direction of rolling",
     [](const Derived& at) -> Summary { return at.scales.hertz.a; }},
    {"b", "b", "m", "half axis along the face, or half the width of a face that is loaded as a whole",
     [](const Derived& at) -> Summary { return if_finite(at.scales.hertz.b); }},
    {"p_hertz", "p_h", "Pa", "largest pressure of the dry contact",
     [](const Derived& at) -> Summary { return at.scales.hertz.pressure; }},
    {"hertz_approach", "delta", "m", "approach of the dry bodies",
     [](const Derived& at) -> Summary { return at.scales.solids.line ? absent() : Summary(at.scales.hertz.approach); }},
    {"M", "M", "-", "Moes' group of the load", [](const Derived& at) -> Summary { return at.groups.M; }},
    {"L", "L", "-", "Moes' group of the lubricant", [](const Derived& at) -> Summary { return at.groups.L; }},
    {"D", "D", "-", "R_x/R_y", [](const Derived& at) -> Summary { return at.groups.D; }},
});

constexpr auto motion_members = std::to_array<Member<Derived>>({
    {"f_m", "f_m", "Hz", "mesh frequency",
     [](const Derived& at) -> Summary { return of_gears(at, mesh_frequency_of); }},
    {"mesh_period", "", "s", "1/f_m",
     [](const Derived& at) -> Summary {
       return of_gears(at, [](const CaseInput& problem) { return 1.0 / mesh_frequency_of(problem); });
     }},
    {"mesh_period_dimensionless", "T_m", "-", "mesh period over a/u_m",
     [](const Derived& at) -> Summary { return of_gears(at, mesh_period); }},
    {"entry_penetration", "", "m",
     "by which an entering tooth meets its mate under the static force; negative: they part",
     [](const Derived& at) -> Summary {
       return at.penetration ? Summary(*at.penetration * at.scales.thickness) : absent();
     }},
    {"corner_contact_distance", "", "m", "how far before the path of contact real tips would touch",
     [](const Derived& at) -> Summary {
       return at.penetration.value_or(0.0) > 0.0 ? Summary(corner_distance(*at.mesh, *at.penetration)) : absent();
     }},
    {"m_ge", "m_ge", "kg", "equivalent mass of the pair",
     [](const Derived& at) -> Summary { return of_mass(at, [](const Derived&, double mass) { return mass; }); }},
    {"I_n", "I_n", "-", "dimensionless inertia",
     [](const Derived& at) -> Summary {
       return of_mass(at, [](const Derived& with, double mass) { return with.scales.inertia(mass); });
     }},
    {"k_el", "k_el", "N/m",
     "stiffness of the dry mesh under the static force, all contacts together, one at the pitch point",
     [](const Derived& at) -> Summary {
       return of_mass(at, [](const Derived& with, double) { return with.mesh->stiffness_si(); });
     }},
    {"f_n", "f_n", "Hz", "natural frequency of the dry pair on that stiffness",
     [](const Derived& at) -> Summary {
       return of_mass(
           at, [](const Derived& with, double mass) { return natural_frequency(with.mesh->stiffness_si(), mass); });
     }},
});

Summary of_formula(const Derived& at, const char* name) { return at.films.contains(name) ? at.films[name] : absent(); }

constexpr auto formula_members = std::to_array<Member<Derived>>({
    {"hamrock_dowson_h_central", "", "m", "central film, formula of Hamrock and Dowson",
     [](const Derived& at) -> Summary { return of_formula(at, "hamrock_dowson_h_central"); }},
    {"hamrock_dowson_h_min", "", "m", "smallest film, formula of Hamrock and Dowson",
     [](const Derived& at) -> Summary { return of_formula(at, "hamrock_dowson_h_min"); }},
    {"nijenbanning_venner_moes_h_central", "", "m", "central film, formula of Nijenbanning, Venner and Moes",
     [](const Derived& at) -> Summary { return of_formula(at, "nijenbanning_venner_moes_h_central"); }},
    {"moes_line_h_central", "", "m", "central film of a line contact under the mean line load, formula of Moes",
     [](const Derived& at) -> Summary { return of_formula(at, "moes_line_h_central"); }},
    {"thermal_loading", "", "-", "thermal loading parameter of the inlet",
     [](const Derived& at) -> Summary { return at.heating["thermal_loading"]; }},
    {"murch_wilson_thermal_factor", "", "-", "factor of the film by heat in the inlet, Murch and Wilson",
     [](const Derived& at) -> Summary { return at.heating["murch_wilson_thermal_factor"]; }},
    {"gupta_thermal_factor", "", "-", "factor of the film by heat in the inlet, Gupta and others",
     [](const Derived& at) -> Summary { return at.heating["gupta_thermal_factor"]; }},
});

constexpr auto numerics_members = std::to_array<Member<Derived>>({
    {"nx", "", "-", "nodes in X on which a run would begin",
     [](const Derived& at) -> Summary { return at.numerics.nx; }},
    {"ny", "", "-", "nodes in Y", [](const Derived& at) -> Summary { return at.numerics.ny; }},
    {"x_min", "", "a", "inlet end of the domain",
     [](const Derived& at) -> Summary { return at.numerics.domain.x_min; }},
    {"x_max", "", "a", "outlet end of the domain",
     [](const Derived& at) -> Summary { return at.numerics.domain.x_max; }},
    {"y_half", "", "b", "half width of the domain",
     [](const Derived& at) -> Summary {
       return has_ellipse(at.scales.solids) ? Summary(at.numerics.domain.y_half) : absent();
     }},
    {"expected_error_h_central", "", "-", "relative error of the central film that such a grid leads to expect",
     [](const Derived& at) -> Summary { return if_finite(at.errors.central); }},
    {"expected_error_h_min", "", "-", "relative error of the smallest film",
     [](const Derived& at) -> Summary { return if_finite(at.errors.smallest); }},
    {"dT", "dT", "-", "time step over a/u_m",
     [](const Derived& at) -> Summary {
       return of_gears(at, [](const CaseInput& problem) { return problem.numerics.steps.dT; });
     }},
    {"steps_in_mesh_period", "", "-", "time steps in a mesh period",
     [](const Derived& at) -> Summary {
       return of_gears(at, [](const CaseInput& problem) { return mesh_period(problem) / problem.numerics.steps.dT; });
     }},
    {"steps_in_free_oscillation", "", "-", "time steps in a free oscillation",
     [](const Derived& at) -> Summary {
       return at.problem.pair.line && at.problem.pair.equivalent_mass
                  ? Summary(natural_period(at.problem) / at.numerics.steps.dT)
                  : absent();
     }},
});

/// In the order in which they are shown.
const std::vector<Member<Derived>>& derived_members() {
  static const std::vector<Member<Derived>> all = [] {
    std::vector<Member<Derived>> list;
    for (const std::span<const Member<Derived>> group :
         {std::span<const Member<Derived>>(gear_members), std::span<const Member<Derived>>(contact_members),
          std::span<const Member<Derived>>(motion_members), std::span<const Member<Derived>>(formula_members),
          std::span<const Member<Derived>>(numerics_members)}) {
      list.insert(list.end(), group.begin(), group.end());
    }
    return list;
  }();
  return all;
}

}  // namespace

Summary film_predictions(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation) {
  Summary found;
  if (solids.rough) {
    const MixedPrediction mixed = masjedi_khonsari(solids, oil, operation);
    found = {{"masjedi_khonsari_h_central", mixed.central_film},
             {"masjedi_khonsari_h_min", mixed.smallest_film},
             {"masjedi_khonsari_asperity_load_share", mixed.load_share},
             {"masjedi_khonsari_valid", mixed.valid}};
  }
  if (!has_ellipse(solids)) {
    found["moes_line_h_central"] = expected_central_film(solids, oil, operation);
    return found;
  }
  found.update({{"hamrock_dowson_h_central", hamrock_dowson_central(solids, oil, operation)},
                {"hamrock_dowson_h_min", hamrock_dowson_minimum(solids, oil, operation)},
                {"nijenbanning_venner_moes_h_central", nijenbanning_venner_moes_central(solids, oil, operation)}});
  return found;
}

Summary derived_quantities(const CaseInput& problem) {
  Summary summary;
  add_members(derived_members(), Derived(problem), summary);
  return summary;
}

std::string derived_markdown() {
  return members_markdown("Quantities of `info`", "Keys of its summary; what a case has no data for is left out.",
                          derived_members());
}

std::vector<std::string> derived_lines(const Summary& quantities) {
  std::vector<std::string> lines;
  for (const Member<Derived>& member : derived_members()) {
    const auto found = quantities.find(member.name);
    if (found == quantities.end()) continue;
    const std::string value =
        found->is_number() ? worded(std::setprecision(8), found->get<double>()) : found->get<std::string>();
    lines.push_back(worded(std::left, std::setw(36), member.name, std::setw(16), value, " ", std::setw(5), member.unit,
                           " ", member.symbol, member.symbol.empty() ? "" : ": ", member.meaning));
  }
  return lines;
}

}  // namespace gearfilm
