#include "gearfilm/app/orbit_errors.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/app/error_bar.hpp"

namespace gearfilm {
namespace {

bool is_force(const PeriodFigure& figure) { return figure.unit.in_si == units::static_force.in_si; }

/// What depends on films, pressures or forces.
bool has_error(const PeriodFigure& figure) {
  const auto of = [&](const Unit& unit) { return figure.unit.name == unit.name && !figure.unit.whole; };
  return of(units::metre) || of(units::pascal) || is_force(figure) || of(units::watt);
}

}  // namespace

std::optional<LargestError> add_errors(const Scales& scales, const FoundOrbit& found, Summary& summary) {
  std::optional<LargestError> largest;
  const auto add = [&](const std::string& name, double fine, std::optional<double> coarse, double least) {
    if (!coarse) return add_error_bar(summary, name, {});
    const Estimate bar = estimate(fine, *coarse, found.ratio);
    add_error_bar(summary, name, bar);
    const double relative = bar.error / std::max(std::abs(bar.extrapolated), least);
    if (!largest || relative > largest->relative) largest = LargestError{name, relative};
  };
  const auto of_coarse = [&](auto value) { return found.coarse ? std::optional(value(*found.coarse)) : std::nullopt; };
  for (std::size_t n = 0; n < period_figures.size(); ++n) {
    const PeriodFigure& figure = period_figures[n];
    const std::optional<double>& fine = found.run.figures.values[n];
    if (!fine || !has_error(figure)) continue;
    const auto in_si = [&](double value) { return figure.unit.in_si(scales, value); };
    std::optional<double> coarse = found.coarse ? found.coarse->figures.values[n] : std::nullopt;
    if (coarse) coarse = in_si(*coarse);
    add(std::string(figure.name), in_si(*fine), coarse, is_force(figure) ? 1.0 : 0.0);
  }
  const auto swing = [&](const OrbitRun& run) { return scales.thickness * run.transmission_error.peak_to_peak; };
  add("transmission_error_peak_to_peak", swing(found.run), of_coarse(swing), 0.0);
  return largest;
}

}  // namespace gearfilm
