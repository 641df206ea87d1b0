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

/// With the errors of steps in time, where the coarse orbit tells those in space alone.
Estimate with_error_in_time(Estimate bar, double coarse, double longer_step) {
  const Estimate in_time = estimate(coarse, longer_step, FoundOrbit::step_ratio);
  bar.error += in_time.error;
  if (bar.extrapolated) *bar.extrapolated += *in_time.extrapolated - coarse;
  return bar;
}

/// Dimensionless, of the figure at that place, but for steps in time that the coarse orbit has too; nothing where an
/// orbit has no value, or no spike.
std::optional<Estimate> error_in_space(std::size_t place, const FoundOrbit& found) {
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

/// Value, error in space and time, and limit of the figure at that place, dimensionless; nothing where an orbit has no
/// value.
std::optional<Estimate> error_of(std::size_t place, const FoundOrbit& found) {
  const std::optional<Estimate> bar = error_in_space(place, found);
  if (!bar || !found.longer_step) return bar;
  const std::optional<double>&coarse = found.coarse->figures.values[place],
        &longer = found.longer_step->figures.values[place];
  if (!longer) return {};
  return with_error_in_time(*bar, *coarse, *longer);
}

std::optional<Estimate> error_of_swing(const FoundOrbit& found) {
  if (!found.coarse) return {};
  const double coarse = found.coarse->transmission_error.peak_to_peak;
  const Estimate bar = estimate(found.run.transmission_error.peak_to_peak, coarse, found.ratio);
  if (!found.longer_step) return bar;
  return with_error_in_time(bar, coarse, found.longer_step->transmission_error.peak_to_peak);
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
  add("transmission_error_peak_to_peak", error_of_swing(found), units::metre, 0.0);
  return largest;
}

}  // namespace gearfilm
