// A quantity: a number that every time step, or every contact in it, gives, as one record.
//
// The records stand in contact_quantities.hpp and step_quantities.hpp. Columns of the history, their units, the
// step log, the quantities of mesh periods, summaries, the columns of a sweep and docs/results.md follow from them.
// Values are dimensionless, those of friction and heat SI; the unit of a record leads to SI.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include "contact/scales.hpp"

namespace gearfilm {

/// The name of a unit, and what a dimensionless value is in it.
struct Unit {
  std::string_view name;
  double (*in_si)(const Scales&, double value);
  bool whole = false;  ///< counts
};

namespace units {
inline constexpr Unit number{"-", [](const Scales&, double value) { return value; }};
inline constexpr Unit count{"-", [](const Scales&, double value) { return value; }, true};
inline constexpr Unit seconds{"s", [](const Scales&, double value) { return value; }};
inline constexpr Unit metre{"m", [](const Scales& scales, double value) { return scales.thickness * value; }};
inline constexpr Unit pascal{"Pa", [](const Scales& scales, double value) { return scales.pressure * value; }};
inline constexpr Unit newton{"N", [](const Scales& scales, double value) { return scales.force(value); }};
/// A force over the static force.
inline constexpr Unit static_force{"-", [](const Scales& scales, double value) { return value / scales.static_force; }};
// Of values that are in SI as they are.
inline constexpr Unit si_newton{"N", [](const Scales&, double value) { return value; }};
inline constexpr Unit si_metre{"m", [](const Scales&, double value) { return value; }};
inline constexpr Unit volume_rate{"m^3/s", [](const Scales&, double value) { return value; }};
inline constexpr Unit si_pascal{"Pa", [](const Scales&, double value) { return value; }};
inline constexpr Unit heat_flux{"W/m^2", [](const Scales&, double value) { return value; }};
inline constexpr Unit watt{"W", [](const Scales&, double value) { return value; }};
inline constexpr Unit kelvin{"K", [](const Scales&, double value) { return value; }};
inline constexpr Unit velocity{
    "m/s", [](const Scales& scales, double value) { return scales.operation.entrainment_velocity * value; }};
}  // namespace units

/// How the values of a quantity in a mesh period become one number. last: the value at the end; at_pitch: at the step
/// nearest xi = 0; at_entry: at the first step after the last entry; mean: in time, of the sum over contacts.
enum class Reduction { largest, smallest, sum, steps, last, at_pitch, at_entry, mean };

/// Where the quantity of a mesh period is shown besides: nowhere, in the summary of a march over all its periods, in
/// the table of a sweep, or both.
enum class ShownIn { period, march, sweep, everywhere };

/// A quantity of a mesh period.
struct Reduced {
  std::string_view name{};  ///< key of summaries, column of a sweep
  Reduction reduction = Reduction::largest;
  Unit unit = units::number;
  std::string_view meaning{};
  ShownIn shown = ShownIn::period;

  bool of_march() const { return shown == ShownIn::march || shown == ShownIn::everywhere; }
  bool of_sweep() const { return shown == ShownIn::sweep || shown == ShownIn::everywhere; }
};

/// What there must be for a quantity to have a value.
enum class RequiredModel {
  nothing,
  film,
  friction,
  heat,
  roughness,
  asperities,
  asperity_area,
  boundary_friction,
  wear,
  stress,
  rating,
  rated_root,
  rated_film,
  rated_heat
};

/// What there is: inertia of the bodies, a film, friction on it, heat in it, roughness of the flanks, asperities that
/// carry and wear, stresses below it, ratings.
struct AvailableModels {
  bool inertia = true;
  bool film = true;
  bool friction = false;
  bool heat = false;
  bool roughness = false;
  bool asperities = false;
  bool asperity_area = false;
  bool wear = false;
  bool stress = false;
  bool rating = false;
  bool rated_root = false;
  bool rated_film = false;

  constexpr bool has(RequiredModel needs) const {
    const bool given[] = {true,
                          true,
                          friction,
                          heat,
                          roughness,
                          asperities,
                          asperity_area,
                          asperities && friction,
                          asperities && wear,
                          stress,
                          rating,
                          rated_root,
                          rated_film,
                          rating && friction};  // in the order of RequiredModel
    return needs == RequiredModel::nothing || (film && given[static_cast<std::size_t>(needs)]);
  }
};

template <class Source>
struct Quantity {
  std::string_view name{};    ///< column of the history
  std::string_view symbol{};  ///< as in docs/symbols.md
  Unit unit = units::number;
  double (*value)(const Source&) = nullptr;
  std::string_view meaning{};
  RequiredModel needs = RequiredModel::nothing;
  std::array<Reduced, 3> reduced{};  ///< those without a name are not there
};

namespace quantity {

/// One record. What reduces it comes last.
template <class Source, class... Reductions>
constexpr Quantity<Source> of(double (*value)(const Source&), std::string_view name, std::string_view symbol,
                              const Unit& unit, std::string_view meaning, RequiredModel needs,
                              const Reductions&... reduced) {
  return {name, symbol, unit, value, meaning, needs, {reduced...}};
}

}  // namespace quantity

/// Place of a name in a table; throws where it is not there, which ends a compilation.
template <class Table>
constexpr std::size_t place_in(const Table& table, std::string_view name) {
  for (std::size_t n = 0; n < table.size(); ++n) {
    if (table[n].name == name) return n;
  }
  throw std::invalid_argument("no quantity has this name");
}

}  // namespace gearfilm
