#include "gearfilm/grid/domain.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/contact/film_formulas.hpp"

namespace gearfilm {
namespace {

constexpr double starvation = 0.003;

// Errors along X per (h_x/H^(2/3))^2.
double central_factor(const ExpectedFilm& at) { return 0.395 * std::pow(at.lubricant, 0.416); }
double smallest_factor(const ExpectedFilm& at) {
  return 0.15 * std::pow(at.lubricant, 0.955) / (1.0 + 0.66 * at.ellipticity);
}
/// The same along Y.
double side_factor(const ExpectedFilm& at) { return 1.3 * at.ellipticity; }
/// The steps along Y up to which the film at the sides is safe from tearing.
double tearing_step(const ExpectedFilm& at) {
  return std::min({0.27 * std::pow(at.film, 0.75) * std::pow(at.ellipticity, -0.25),
                   0.57 * at.film * std::pow(at.ellipticity, -0.5),
                   1.1 * std::pow(at.film, 0.885) * std::pow(at.ellipticity, -0.49) * std::pow(at.lubricant, -0.61)});
}

}  // namespace

ExpectedFilm::ExpectedFilm(const Scales& scales)
    : film(nijenbanning_venner_moes_central(scales.solids, scales.oil, scales.operation) / scales.thickness),
      lubricant(moes_groups(scales.solids, scales.oil, scales.operation).L),
      ellipticity(scales.hertz.ellipticity) {}

double inlet_rise(const ExpectedFilm& expected) { return std::cbrt(expected.film * expected.film); }

double flooded_inlet(const ExpectedFilm& expected) {
  const double slender =
      std::sqrt(0.328 * std::pow(expected.lubricant, 0.285) * std::pow(expected.film, 1.15) / starvation);
  double x = slender;
  // Each brings it nearer by half at least.
  for (int n = 0; n < 60; ++n) x = slender / std::sqrt(1.0 + 0.707 * expected.ellipticity * x);
  return x;
}

double clear_side(const ExpectedFilm& expected) { return 1.03 + expected.ellipticity * flooded_inlet(expected); }

Domain domain_of(const ExpectedFilm& expected) {
  return {-1.2 - flooded_inlet(expected), 1.25, 1.08 * clear_side(expected)};
}

FilmErrors expected_errors(const ExpectedFilm& expected, const Steps& steps) {
  const double x = std::pow(steps.x / inlet_rise(expected), 2), y = std::pow(steps.y / inlet_rise(expected), 2);
  // The central film has a quarter of the smallest film's error along Y.
  const double side = side_factor(expected) * y;
  const double smallest = steps.y < 1.2 * tearing_step(expected) ? smallest_factor(expected) * x + side : HUGE_VAL;
  return {central_factor(expected) * x + 0.25 * side, smallest};
}

Steps steps_for(const ExpectedFilm& expected, double accuracy) {
  // Three quarters of the error come from the steps along X, where a node gains most.
  const double factor = std::max(central_factor(expected), smallest_factor(expected));
  const double x = std::sqrt(0.75 * accuracy / factor) * inlet_rise(expected);
  const double y = std::sqrt(0.25 * accuracy / side_factor(expected)) * inlet_rise(expected);
  return {x, std::min(y, 0.8 * tearing_step(expected))};
}

int nodes_along(double length, double step) {
  constexpr int block = 16, fewest = 32;
  const int cells = block * static_cast<int>(std::ceil(length / (block * step) - 1e-9));
  return std::max(cells, fewest) + 1;
}

}  // namespace gearfilm
