#include "input/case_stress.hpp"

#include <algorithm>

#include "gearfilm/error.hpp"
#include "stress/first_yield.hpp"
#include "stress/stress_depths.hpp"

namespace gearfilm {
namespace {

/// Of both bodies; a bare contact may have only its reduced modulus.
std::array<double, body_count> read_poisson_ratios(const ParameterValues& values) {
  const std::array<std::string, 2> keys = values.body_keys("poisson_ratio");
  std::array<double, body_count> ratios{};
  for (std::size_t body = 0; body < body_count; ++body) {
    if (!values.has(keys[body])) {
      values.refuse("stress.model", "is " + values.text("stress.model") + ", but '" + keys[body] +
                                        "' is missing, on which stresses depend; give moduli and ratios of both bodies "
                                        "in the place of contact.reduced_modulus");
    }
    ratios[body] = values.real(keys[body]);
  }
  return ratios;
}

}  // namespace

std::optional<StressModel> read_stress(const ParameterValues& values) {
  const std::string model = "stress.model";
  if (values.text(model) == "none") return {};
  if (values.text("case.kind") == "gear_pair" && values.text("model") == "dry") {
    values.refuse(model, "is " + values.text(model) +
                             ", but model dry has no films below which stresses are computed; delete one");
  }
  return StressModel{.depths = stress_depths(values.real("stress.depth_max"), values.integer("stress.points")),
                     .poisson_ratio = read_poisson_ratios(values),
                     .whole_fields = values.text(model) == "field",
                     .every = values.real("stress.every"),
                     .all_rows = values.text("stress.rows") == "all"};
}

std::optional<double> first_yield_pressure(const ParameterValues& values, const Scales& scales) {
  if (values.text("case.kind") != "gear_pair") return {};
  std::optional<double> smallest;
  for (const char* key : {"pinion.yield_stress", "wheel.yield_stress"}) {
    const std::optional<double> stress = values.real_if_given(key);
    if (stress) smallest = std::min(*stress, smallest.value_or(*stress));
  }
  if (!smallest) return {};
  const bool along_face = scales.solids.face || scales.solids.line;
  const double axes = scales.hertz.ellipticity;
  return *smallest * first_yield_ratio(along_face ? 0.0 : std::min(axes, 1.0 / axes));
}

}  // namespace gearfilm
