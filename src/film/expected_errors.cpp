#include "film/expected_errors.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

constexpr double safe = 2.0 / 3.0;  // of the step from which on films tear
constexpr double along_x = 0.7;     // of the errors, where a node gains most; the rest comes from the steps along Y

/// Factors of the errors' powers of steps.
struct Law {
  double central_rise, central_step;  ///< of r_x^central_order and h_x^2
  int central_order;
  double smallest_rise;                ///< of r_x^2
  double central_side, smallest_side;  ///< of h_y^2 or r_y^2, and of r_y^2
  double tearing_step;                 ///< h_y from which on films tear
};

double power_of(double base, int order) { return order == 2 ? base * base : base * base * base * base; }

Law law_of(FilmDiscretisation discretisation, const ExpectedFilm& at) {
  const double kappa = at.ellipticity, kappa_4 = std::pow(at.ellipticity, 4), slender = 1.0 / (1.0 + 0.66 * kappa),
               l = inlet_rise(at), length = pressure_length(at);
  const double tearing =
      std::min({0.27 * std::pow(at.film, 0.75) * std::pow(kappa, -0.25), 0.57 * at.film * std::pow(kappa, -0.5),
                1.1 * std::pow(at.film, 0.885) * std::pow(kappa, -0.49) * std::pow(at.lubricant, -0.61)});
  if (at.rough) {
    return {.central_rise = 0.12,
            .central_step = 0.25 / (length * length),
            .central_order = 4,
            .smallest_rise = 0.012 * std::pow(at.lubricant, 0.9) * slender,
            .central_side = 0.5 * std::sqrt(kappa) * l * l,
            .smallest_side = std::sqrt(kappa) * l * l,
            .tearing_step = HUGE_VAL};
  }
  if (discretisation == FilmDiscretisation::fitted) {
    return {.central_rise = 0.12,
            .central_step = 0.25 / (length * length),
            .central_order = 4,
            .smallest_rise = 0.012 * std::pow(at.lubricant, 0.9) * slender,
            .central_side = 0.12 * std::sqrt(kappa) * l * l,
            .smallest_side = 0.4 * kappa_4 / (kappa_4 + std::pow(0.16, 4)),
            .tearing_step = 3.0 * tearing};
  }
  return {.central_rise = 0.395 * std::pow(at.lubricant, 0.416),
          .central_step = 0.0,
          .central_order = 2,
          .smallest_rise = 0.15 * std::pow(at.lubricant, 0.955) * slender,
          .central_side = 0.25 * 1.3 * kappa,
          .smallest_side = 1.3 * kappa,
          .tearing_step = 1.2 * tearing};
}

/// The h_x with which rise (h_x/l)^order + step h_x^2 is the error.
double longest_step(double rise, int order, double step, double l, double error) {
  if (order == 2) return std::sqrt(error / (rise / (l * l) + step));
  const double a = rise / (l * l * l * l);
  return std::sqrt(2.0 * error / (step + std::sqrt(step * step + 4.0 * a * error)));
}

}  // namespace

FilmErrors expected_errors(FilmDiscretisation discretisation, const ExpectedFilm& expected, const Steps& steps) {
  const Law law = law_of(discretisation, expected);
  const double l = inlet_rise(expected), r_x = steps.x / l, r_y = steps.y / l;
  const double central = law.central_rise * power_of(r_x, law.central_order) + law.central_step * steps.x * steps.x +
                         law.central_side * r_y * r_y;
  const double smallest = law.smallest_rise * r_x * r_x + law.smallest_side * r_y * r_y;
  return {central, steps.y < law.tearing_step ? smallest : HUGE_VAL};
}

double longest_side_step(FilmDiscretisation discretisation, const ExpectedFilm& expected) {
  return safe * law_of(discretisation, expected).tearing_step;
}

Steps steps_for(FilmDiscretisation discretisation, const ExpectedFilm& expected, double accuracy) {
  const Law law = law_of(discretisation, expected);
  const double l = inlet_rise(expected);
  const double x = std::min(longest_step(law.central_rise, law.central_order, law.central_step, l, along_x * accuracy),
                            longest_step(law.smallest_rise, 2, 0.0, l, along_x * accuracy));
  const double y = std::sqrt((1.0 - along_x) * accuracy / std::max(law.central_side, law.smallest_side)) * l;
  return {x, std::min(y, longest_side_step(discretisation, expected))};
}

}  // namespace gearfilm
