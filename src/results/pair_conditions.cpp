#include "results/pair_conditions.hpp"

#include "results/members.hpp"

namespace gearfilm {
namespace {

/// Null of a pair in balance whose inertia is not given.
Summary frequency(const PairConditions& at) {
  if (!at.here.pair.equivalent_mass) return {};
  const Scales& scales = at.here.scales;
  return natural_frequency(at.here.pair.stiffness, scales.inertia(*at.here.pair.equivalent_mass)) / scales.time;
}

constexpr auto condition_members = std::to_array<Member<PairConditions>>({
    {"speed_rpm", "", "rpm", "speed of the pinion",
     [](const PairConditions& at) -> Summary { return at.here.parameters.real("pinion.speed_rpm"); }, Column::real},
    {"torque", "T_g1", "N m", "torque of the pinion",
     [](const PairConditions& at) -> Summary { return at.here.pair.torque; }, Column::real},
    {"m_ge", "m_ge", "kg", "equivalent mass of the pair",
     [](const PairConditions& at) -> Summary { return known(at.here.pair.equivalent_mass); }, Column::real},
    {"viscosity", "eta_0", "Pa s", "viscosity at ambient pressure",
     [](const PairConditions& at) -> Summary { return at.here.scales.oil.viscosity; }, Column::real},
    {"I_n", "I_n", "-", "dimensionless inertia", [](const PairConditions& at) -> Summary { return at.mesh.inertia; },
     Column::real},
    {"f_m", "f_m", "Hz", "mesh frequency",
     [](const PairConditions& at) -> Summary { return at.mesh.mesh_frequency_si(); }, Column::real},
    {"f_n", "f_n", "Hz", "natural frequency of the dry pair", frequency, Column::real},
});

}  // namespace

void add_conditions(const PairConditions& at, Summary& result) { add_members(condition_members, at, result); }

std::vector<TableColumn> condition_columns() { return columns_of(condition_members); }

void add_conditions_to_row(const PairConditions& at, std::vector<double>& row) {
  add_to_row(condition_members, at, row);
}

std::string conditions_markdown() {
  return members_markdown(
      "Conditions of a point",
      "Keys of each point of `sweep` and of each bifurcation of `continuation`; columns of `/sweep` "
      "and `/continuation`.",
      condition_members);
}

}  // namespace gearfilm
