#include "orbits/orbit_errors.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "gearfilm/error.hpp"
#include "orbits/described_dry_orbit.hpp"

namespace gearfilm {
namespace {

constexpr PeriodQuantityName largest_pressure = "p_max", spike_pressure = "p_spike_max";
constexpr ContactQuantityName smallest_film = "h_min";
/// Relative, of forces and of the transmission error: what oil beyond the edges of the chosen domains would change.
constexpr double left_out = 0.005;

bool is_force(const PeriodQuantity& quantity) { return quantity.unit.in_si == units::static_force.in_si; }

/// What depends on films, pressures or forces.
bool has_error(const PeriodQuantity& quantity) {
  const auto of = [&](const Unit& unit) { return quantity.unit.name == unit.name && !quantity.unit.whole; };
  return of(units::metre) || of(units::pascal) || is_force(quantity) || of(units::watt);
}

/// Fitted films, and what follows from them, have a bar of so much of themselves at least.
Estimate with_least_bar(Estimate bar, double least, FilmDiscretisation discretisation) {
  if (discretisation == FilmDiscretisation::fitted) bar.error = std::max(bar.error, least * std::abs(bar.value));
  return bar;
}

/// The law's estimate for a quantity of two orbits; of one at the pitch point at least that of its largest difference
/// nearby.
template <class Law>
std::optional<Estimate> estimate_of(std::size_t place, const DescribedOrbit& own, const DescribedOrbit& other,
                                    Law law) {
  const std::optional<double>&value = own.quantities.values[place], &others = other.quantities.values[place];
  if (!value || !others) return {};
  Estimate bar = law(*value, *others);
  const PeriodQuantity& quantity = period_quantities[place];
  if (quantity.reduction != Reduction::at_pitch) return bar;
  const std::optional<double> change = largest_relative_change(own.pitch_films, other.pitch_films, quantity.source);
  if (change) bar.error = std::max(bar.error, law(*value, *value * (1.0 + *change)).error);
  return bar;
}

/// The error of steps in time, where the coarse orbit tells that in space alone.
Estimate estimate_in_time(double coarse, double longer_step) {
  return estimate(coarse, longer_step, FoundOrbit::step_ratio);
}

Estimate with_error_in_time(Estimate bar, const Estimate& in_time) {
  bar.error += in_time.error;
  if (bar.extrapolated) *bar.extrapolated += *in_time.extrapolated - in_time.value;
  return bar;
}

/// Dimensionless, of the quantity at that place, but for steps in time that the coarse orbit has too; nothing where an
/// orbit has no value, or no spike.
std::optional<Estimate> error_in_space(std::size_t place, const FoundOrbit& found) {
  const PeriodQuantities &fine = found.own.quantities, &coarse = found.coarse->quantities;
  const double ratio = found.ratio;
  const auto with_spike = [](double pressure, const PeriodQuantities& quantities) {
    return PeakPressures{pressure, quantities[spike_pressure].value_or(0.0)};
  };
  const PeriodQuantity& quantity = period_quantities[place];
  if (place == spike_pressure.place || place == largest_pressure.place) {
    const std::optional<double>&own = fine.values[place], &other = coarse.values[place];
    if (!own || !other) return {};
    if (place == spike_pressure.place) return estimate_spike(*own, *other, ratio);
    return estimate_largest(with_spike(*own, fine), with_spike(*other, coarse), found.own.orbit.end.shape.h_x(), ratio);
  }
  const bool smallest = quantity.of_contact && quantity.source == smallest_film.place;
  const std::optional<Estimate> bar = estimate_of(place, found.own, *found.coarse, [&](double own, double other) {
    return smallest ? estimate_smallest(own, other, ratio) : estimate(own, other, ratio);
  });
  if (!bar) return {};
  const double least = is_force(quantity) ? left_out : smallest ? least_bars.smallest : least_bars.central;
  return with_least_bar(*bar, least, found.discretisation);
}

/// Value, error in space and time, and limit of the quantity at that place, dimensionless; nothing where an orbit has
/// no value.
std::optional<Estimate> error_of(std::size_t place, const FoundOrbit& found) {
  const std::optional<Estimate> bar = error_in_space(place, found);
  if (!bar || !found.longer_step) return bar;
  const std::optional<Estimate> in_time = estimate_of(place, *found.coarse, *found.longer_step, estimate_in_time);
  if (!in_time) return {};
  return with_error_in_time(*bar, *in_time);
}

std::optional<Estimate> error_of_swing(const FoundOrbit& found) {
  if (!found.coarse) return {};
  const double coarse = found.coarse->transmission_error.peak_to_peak;
  const Estimate bar = with_least_bar(estimate(found.own.transmission_error.peak_to_peak, coarse, found.ratio),
                                      left_out, found.discretisation);
  if (!found.longer_step) return bar;
  return with_error_in_time(bar, estimate_in_time(coarse, found.longer_step->transmission_error.peak_to_peak));
}

}  // namespace

std::string LargestError::text() const {
  return worded(quantity, " has an error of about ", std::fixed, std::setprecision(0), 100.0 * relative, " %", scale);
}

FoundOrbit find_orbit_with_errors(const OrbitProblem& problem, const SharedDiscretisation& films,
                                  const SearchWatch& watch) {
  if (!films) return {.own = find_described_dry_orbit(problem, watch.on_step, counted(watch.check_stop))};
  FoundOrbit found = find_orbit(problem, films, dry_start(problem.mesh), watch);
  find_coarse_orbit(problem, watch, films->grid().comm(), found);
  return found;
}

std::optional<Estimate> OrbitError::in_si(const Scales& scales) const {
  if (!bar) return {};
  const double factor = unit.in_si(scales, 1.0);
  Estimate result{factor * bar->value, factor * bar->error};
  if (bar->extrapolated) result.extrapolated = factor * *bar->extrapolated;
  return result;
}

std::vector<OrbitError> errors_of(const FoundOrbit& found) {
  std::vector<OrbitError> errors;
  for (std::size_t n = 0; n < period_quantities.size(); ++n) {
    const PeriodQuantity& quantity = period_quantities[n];
    if (!has_error(quantity) || !found.own.quantities.values[n]) continue;
    errors.push_back(
        {std::string(quantity.name), quantity.unit, found.coarse ? error_of(n, found) : std::optional<Estimate>()});
  }
  errors.push_back({"transmission_error_peak_to_peak", units::metre, error_of_swing(found)});
  return errors;
}

std::optional<LargestError> largest_of(const std::vector<OrbitError>& errors, const Scales& scales) {
  std::optional<LargestError> largest;
  for (const OrbitError& error : errors) {
    const std::optional<Estimate> bar = error.in_si(scales);
    if (!bar || !bar->extrapolated) continue;  // a spike's is no fault of this grid alone
    const bool force = error.unit.in_si == units::static_force.in_si;
    const bool rough = scales.solids.rough && error.unit.in_si == units::metre.in_si;
    const double least = force ? 1.0 : rough ? scales.solids.rough->sigma() : 0.0;
    const double relative = Estimate{bar->value, bar->error, bar->extrapolated, least}.relative_error();
    if (largest && relative <= largest->relative) continue;
    const bool by_scale = std::abs(bar->value) < least;
    largest = LargestError{error.name, relative, !by_scale ? "" : force ? " of the static force" : " of the roughness"};
  }
  return largest;
}

}  // namespace gearfilm
