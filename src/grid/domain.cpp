#include "grid/domain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/line_contact.hpp"

namespace gearfilm {
namespace {

constexpr double starvation = 0.003;
constexpr double rupture_between_cylinders = 0.475;  // rigid ones, behind their middle, in sqrt(2 R_x h)
constexpr double least_gap = 0.3;                    // of rough surfaces that oil flows through, in sigma

}  // namespace

ExpectedFilm::ExpectedFilm(const Scales& scales)
    : film(expected_central_film(scales.solids, scales.oil, scales.operation) / scales.thickness),
      lubricant(moes_groups(scales.solids, scales.oil, scales.operation).L),
      ellipticity(scales.hertz.ellipticity),
      rough(scales.solids.rough != nullptr),
      reach(asperity_reach(scales)) {
  if (rough) film = std::max(film, least_gap * scales.solids.rough->sigma() / scales.thickness);
}

double asperity_reach(const Scales& scales) {
  if (!scales.solids.rough) return 0.0;
  constexpr double furthest = 4.0;  // in sigma
  const double gap = furthest * scales.solids.rough->sigma() / scales.thickness;
  return std::pow(1.5 / std::numbers::sqrt2 * gap, 2.0 / 3.0);
}

double inlet_rise(const ExpectedFilm& expected) { return std::cbrt(expected.film * expected.film); }

double pressure_length(const ExpectedFilm& expected) { return std::max(1.0, inlet_rise(expected)); }

double flooded_inlet(const ExpectedFilm& expected) {
  const double slender =
      std::sqrt(0.328 * std::pow(expected.lubricant, 0.285) * std::pow(expected.film, 1.15) / starvation);
  double x = slender;
  // Each brings it nearer by half at least.
  for (int n = 0; n < 60; ++n) x = slender / std::sqrt(1.0 + 0.707 * expected.ellipticity * x);
  return x;
}

double clear_side(const ExpectedFilm& expected) {
  return 1.03 + std::max(expected.ellipticity * flooded_inlet(expected), expected.reach);
}

Domain domain_of(const ExpectedFilm& expected) {
  const double outlet = std::max(1.25, 1.3 * rupture_between_cylinders * std::sqrt(2.0 * expected.film));
  return {-1.2 - std::max(flooded_inlet(expected), expected.reach), outlet + expected.reach,
          1.08 * clear_side(expected)};
}

namespace {

int nodes_in_blocks(double length, double step, int block, int fewest) {
  const int blocks = static_cast<int>(std::ceil(length / (block * step) - 1e-9));
  return block * std::max(blocks, fewest) + 1;
}

}  // namespace

int nodes_along(double length, double step) { return nodes_in_blocks(length, step, 16, 4); }
int nodes_across(double length, double step) { return nodes_in_blocks(length, step, 8, 2); }

}  // namespace gearfilm
