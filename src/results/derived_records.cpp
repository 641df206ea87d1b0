#include "results/derived_records.hpp"

#include <algorithm>
#include <array>

namespace gearfilm {
namespace {

constexpr auto records = std::to_array<DerivedRecord>({
    {"case", "", "", "name of the case"},
    {"working_pressure_angle_deg", "alpha_w", "deg", "working pressure angle"},
    {"base_radius_pinion", "r_b1", "m", "base radius of the pinion"},
    {"base_radius_wheel", "r_b2", "m", "base radius of the wheel"},
    {"base_pitch", "p_b", "m", "distance of two contacts on the line of action"},
    {"xi_entry", "xi_a", "m", "where a contact enters, from the pitch point"},
    {"xi_exit", "xi_e", "m", "where a contact leaves, from the pitch point"},
    {"contact_ratio", "epsilon", "-", "contacts at a time, on the average"},
    {"implied_backlash", "j_n", "m", "normal backlash that both given profile shifts leave at the centre distance"},
    {"R_x", "R_x", "m", "reduced radius in the direction of rolling, at the pitch point or of the bare contact"},
    {"R_y", "R_y", "m", "reduced radius along the face"},
    {"E_prime", "E'", "Pa", "reduced modulus"},
    {"load", "w*", "N", "static force along the line of action, or the point load that stands for it"},
    {"tooth_force", "", "N", "static force along the line of action"},
    {"entrainment_velocity", "u_m", "m/s", "mean of the velocities of both flanks"},
    {"kappa", "kappa", "-", "ratio of the half axes a/b of the Hertz ellipse"},
    {"a", "a", "m", "half axis of the ellipse in the direction of rolling"},
    {"b", "b", "m", "half axis along the face"},
    {"p_hertz", "p_h", "Pa", "largest pressure of the dry contact"},
    {"hertz_approach", "delta", "m", "approach of the dry bodies"},
    {"M", "M", "-", "Moes' group of the load"},
    {"L", "L", "-", "Moes' group of the lubricant"},
    {"D", "D", "-", "R_x/R_y"},
    {"f_m", "f_m", "Hz", "mesh frequency"},
    {"mesh_period", "", "s", "1/f_m"},
    {"mesh_period_dimensionless", "T_m", "-", "mesh period over a/u_m"},
    {"entry_penetration", "", "m",
     "by which an entering tooth meets its mate under the static force; negative: they part"},
    {"corner_contact_distance", "", "m", "how far before the path of contact real tips would touch"},
    {"m_ge", "m_ge", "kg", "equivalent mass of the pair"},
    {"I_n", "I_n", "-", "dimensionless inertia"},
    {"k_el", "k_el", "N/m",
     "stiffness of the dry mesh under the static force, all contacts together, one at the pitch point"},
    {"f_n", "f_n", "Hz", "natural frequency of the dry pair on that stiffness"},
    {"hamrock_dowson_h_central", "", "m", "central film, formula of Hamrock and Dowson"},
    {"hamrock_dowson_h_min", "", "m", "smallest film, formula of Hamrock and Dowson"},
    {"nijenbanning_venner_moes_h_central", "", "m", "central film, formula of Nijenbanning, Venner and Moes"},
    {"thermal_loading", "", "-", "thermal loading parameter of the inlet"},
    {"murch_wilson_thermal_factor", "", "-", "factor of the film by heat in the inlet, Murch and Wilson"},
    {"gupta_thermal_factor", "", "-", "factor of the film by heat in the inlet, Gupta and others"},
    {"nx", "", "-", "nodes in X on which a run would begin"},
    {"ny", "", "-", "nodes in Y"},
    {"x_min", "", "a", "inlet end of the domain"},
    {"x_max", "", "a", "outlet end of the domain"},
    {"y_half", "", "b", "half width of the domain"},
    {"expected_error_h_central", "", "-", "relative error of the central film that such a grid leads to expect"},
    {"expected_error_h_min", "", "-", "relative error of the smallest film"},
    {"dT", "dT", "-", "time step over a/u_m"},
    {"steps_in_mesh_period", "", "-", "time steps in a mesh period"},
    {"steps_in_free_oscillation", "", "-", "time steps in a free oscillation"},
});

}  // namespace

std::span<const DerivedRecord> derived_records() { return records; }

DerivedRecord derived_record(std::string_view name) {
  const auto found = std::ranges::find(records, name, &DerivedRecord::name);
  return found == records.end() ? DerivedRecord{name, "", "", ""} : *found;
}

std::string derived_markdown() {
  std::string text =
      "\n## Quantities of `info`\n\nKeys of its summary; what a case has no data for is left out.\n\n"
      "| Key | Symbol | Unit | Meaning |\n|---|---|---|---|\n";
  for (const DerivedRecord& record : records) {
    text.append("| `").append(record.name).append("` | ");
    if (!record.symbol.empty()) text.append("`").append(record.symbol).append("` ");
    text.append("| ").append(record.unit).append(record.unit.empty() ? "| " : " | ");
    text.append(record.meaning).append(" |\n");
  }
  return text;
}

}  // namespace gearfilm
