#include "gearfilm/app/orbit_errors.hpp"

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
  const auto add = [&](const std::string& name, auto value_of, double least) {
    const std::optional<double> fine = value_of(found.run);
    if (!fine) return;
    const std::optional<double> coarse = found.coarse ? value_of(*found.coarse) : std::nullopt;
    if (!coarse) return add_error_bar(summary, name, {});
    const Estimate bar = estimate(*fine, *coarse, found.ratio);
    add_error_bar(summary, name, bar);
    const double relative = bar.relative_error(least);
    if (!largest || relative > largest->relative) largest = LargestError{name, relative};
  };
  for (std::size_t n = 0; n < period_figures.size(); ++n) {
    const PeriodFigure& figure = period_figures[n];
    if (!has_error(figure)) continue;
    const auto in_si = [&](const OrbitRun& run) {
      const std::optional<double>& value = run.figures.values[n];
      return value ? std::optional(figure.unit.in_si(scales, *value)) : std::nullopt;
    };
    add(std::string(figure.name), in_si, is_force(figure) ? 1.0 : 0.0);
  }
  const auto swing = [&](const OrbitRun& run) {
    return std::optional(scales.thickness * run.transmission_error.peak_to_peak);
  };
  add("transmission_error_peak_to_peak", swing, 0.0);
  return largest;
}

}  // namespace gearfilm
