#include "app/orbit_errors.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "app/error_bar.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

constexpr PeriodFigureName largest_pressure = "p_max", spike_pressure = "p_spike_max";
constexpr ContactFigureName smallest_film = "h_min";

bool is_force(const PeriodFigure& figure) { return figure.unit.in_si == units::static_force.in_si; }

/// What depends on films, pressures or forces.
bool has_error(const PeriodFigure& figure) {
  const auto of = [&](const Unit& unit) { return figure.unit.name == unit.name && !figure.unit.whole; };
  return of(units::metre) || of(units::pascal) || is_force(figure) || of(units::watt);
}

/// Dimensionless, of the figure at that place; nothing where an orbit has no value, or no spike.
std::optional<Estimate> error_of(std::size_t place, const FoundOrbit& found) {
  const PeriodFigures &fine = found.run.figures, &coarse = found.coarse->figures;
  const std::optional<double>&own = fine.values[place], &other = coarse.values[place];
  if (!own || !other) return {};
  const auto with_spike = [](double pressure, const PeriodFigures& figures) {
    return PeakPressures{pressure, figures[spike_pressure].value_or(0.0)};
  };
  const PeriodFigure& figure = period_figures[place];
  if (place == spike_pressure.place) return estimate_spike(*own, *other, found.ratio);
  if (place == largest_pressure.place)
    return estimate_largest(with_spike(*own, fine), with_spike(*other, coarse), found.run.orbit.end.shape.h_x(),
                            found.ratio);
  const bool smallest = figure.of_contact && figure.source == smallest_film.place;
  Estimate bar = smallest ? estimate_smallest(*own, *other, found.ratio) : estimate(*own, *other, found.ratio);
  if (found.discretisation == FilmDiscretisation::fitted) {
    bar.error = std::max(bar.error, (smallest ? least_bars.smallest : least_bars.central) * std::abs(bar.value));
  }
  return bar;
}

}  // namespace

std::string LargestError::text() const {
  return worded(figure, " has an error of about ", std::fixed, std::setprecision(0), 100.0 * relative, " %",
                (of_static_force ? " of the static force" : ""));
}

std::optional<LargestError> add_errors(const Scales& scales, const FoundOrbit& found, Summary& summary) {
  std::optional<LargestError> largest;
  const auto add = [&](const std::string& name, const std::optional<Estimate>& bar, const Unit& unit, double least) {
    add_error_bar(summary, name, bar, unit.in_si(scales, 1.0));
    if (!bar || !bar->extrapolated) return;  // a spike's is no fault of this grid alone
    const Estimate in_si{unit.in_si(scales, bar->value), unit.in_si(scales, bar->error)};
    const double relative = in_si.relative_error(least);
    if (!largest || relative > largest->relative) largest = LargestError{name, relative, std::abs(in_si.value) < least};
  };
  for (std::size_t n = 0; n < period_figures.size(); ++n) {
    const PeriodFigure& figure = period_figures[n];
    if (!has_error(figure) || !found.run.figures.values[n]) continue;
    const std::optional<Estimate> bar = found.coarse ? error_of(n, found) : std::nullopt;
    add(std::string(figure.name), bar, figure.unit, is_force(figure) ? 1.0 : 0.0);
  }
  const double swing = found.run.transmission_error.peak_to_peak;
  add("transmission_error_peak_to_peak",
      found.coarse ? std::optional(estimate(swing, found.coarse->transmission_error.peak_to_peak, found.ratio))
                   : std::nullopt,
      units::metre, 0.0);
  return largest;
}

}  // namespace gearfilm
