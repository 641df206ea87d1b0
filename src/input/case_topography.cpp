#include "input/case_topography.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "contact/waviness_formulas.hpp"
#include "input/surface_file.hpp"
#include "roughness/measured_profile.hpp"

namespace gearfilm {
namespace {

const std::string model_key = "roughness.model", direction = "roughness.direction", cutoff_key = "roughness.cutoff";
const std::array<std::string, 2> surfaces = {"pinion.surface", "wheel.surface"};

struct WaveKeys {
  std::string amplitude, wavelength, phase;
};
WaveKeys wave_keys(std::size_t body) {
  const std::string ending = body == 0 ? "_1" : "_2";
  return {"roughness.amplitude" + ending, "roughness.wavelength" + ending, "roughness.phase" + ending};
}

void refuse_heights(const ParameterValues& values) {
  if (values.text("case.kind") != "gear_pair") return;
  std::vector<std::string> keys = {surfaces[0], surfaces[1], cutoff_key};
  for (std::size_t body : {0, 1}) {
    const WaveKeys wave = wave_keys(body);
    keys.insert(keys.end(), {wave.amplitude, wave.wavelength});
    if (values.real(wave.phase) != 0.0) keys.push_back(wave.phase);
  }
  for (const std::string& key : keys) {
    if (!values.given(key)) continue;
    values.refuse(key,
                  "is given, but " + model_key + " is " + values.text(model_key) + "; set it to deterministic or both");
  }
}

std::optional<Waviness> read_wave(const ParameterValues& values, std::size_t body) {
  const WaveKeys keys = wave_keys(body);
  values.require_both(keys.amplitude, keys.wavelength, "give amplitude and wavelength, or neither");
  const bool across = values.text(direction) == "longitudinal";
  if (values.real(keys.phase) != 0.0 && (across || !values.has(keys.amplitude)))
    values.refuse(keys.phase, across ? "is given, but waves across the face are mirror images; delete it"
                                     : "is given, but not '" + keys.amplitude + "'; delete it");
  if (!values.has(keys.amplitude)) return {};
  return Waviness{values.real(keys.amplitude), values.real(keys.wavelength), values.real(keys.phase)};
}

SplitProfile read_split_profile(const ParameterValues& values, const std::string& name, double middle, double cutoff) {
  constexpr double cutoffs = 3.0, most_form = 10.0;
  const std::vector<std::pair<double, double>> points = read_surface(values, name, middle);
  const double length = points.back().first - points.front().first;
  if (length < cutoffs * cutoff)
    values.refuse(name, "is '" + values.text(name) + "', which is " + format_value(length) +
                            " m long; it must be at least three times as long as " + cutoff_key + ", " +
                            format_value(cutoff) + " m");
  SplitProfile split = split_profile(points, cutoff);
  if (split.form > most_form * split.rms)
    values.refuse(name, "is '" + values.text(name) + "', which has its form left in: a parabola " +
                            format_value(split.form) + " m deep under a roughness of " + format_value(split.rms) +
                            " m; take the form off and give it as profile_file");
  return split;
}

FlankTopography heights_of(const ParameterValues& values, const LineOfAction& line, const Scales& scales) {
  FlankTopography result;
  const std::array<double, 2> middle = line.involute_lengths(0.0);
  const bool across = values.text(direction) == "longitudinal";
  const double cutoff = values.real_if_given(cutoff_key).value_or(0.25 * scales.hertz.a);
  const auto remaining = [&](double wavelength) {
    return wavelength < HUGE_VAL ? remaining_amplitude(scales.solids, scales.oil, scales.hertz,
                                                       scales.operation.entrainment_velocity, wavelength)
                                 : 1.0;
  };
  std::array<Topography, 2> flanks;
  for (std::size_t body = 0; body < flanks.size(); ++body) {
    const std::optional<Waviness> wave = read_wave(values, body);
    HeightProfile profile;
    double shortest = HUGE_VAL;
    if (values.has(surfaces[body])) {
      SplitProfile split = read_split_profile(values, surfaces[body], middle[body], cutoff);
      result.shorter[body] = split.shorter_rms;
      shortest = cutoff;
      profile = std::move(split.resolved);
    }
    if (wave && across) result.shortest_across = std::min(result.shortest_across, wave->wavelength);
    if (wave && !across) shortest = std::min(shortest, wave->wavelength);
    flanks[body] = Topography(across ? std::nullopt : wave, across ? wave : std::nullopt, profile, remaining(shortest));
    result.shortest_along = std::min(result.shortest_along, shortest);
  }
  if (flanks[0].flat() && flanks[1].flat())
    values.refuse(model_key,
                  "is " + values.text(model_key) + ", but neither flank has waves or a measured surface; give '" +
                      wave_keys(0).amplitude + "' and '" + wave_keys(0).wavelength + "', or '" + surfaces[0] + "'");
  result.flanks = std::make_shared<const std::array<Topography, 2>>(std::move(flanks));
  return result;
}

}  // namespace

bool has_stochastic_roughness(const ParameterValues& values) {
  return values.text(model_key) == "stochastic" || values.text(model_key) == "both";
}

bool has_deterministic_roughness(const ParameterValues& values) {
  return values.text("case.kind") == "gear_pair" &&
         (values.text(model_key) == "deterministic" || values.text(model_key) == "both");
}

FlankTopography read_topography(const ParameterValues& values, const std::optional<LineOfAction>& line,
                                const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation) {
  if (has_deterministic_roughness(values)) return heights_of(values, *line, make_scales(solids, oil, operation));
  refuse_heights(values);
  return {};
}

}  // namespace gearfilm
