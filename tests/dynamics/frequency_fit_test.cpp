// A free oscillation stepped by difference formulas whose inertia and damping are fitted to it.
#include "dynamics/frequency_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dynamics/slope_weights.hpp"

namespace gearfilm {
namespace {

constexpr double w = 1.7;

/// H and V = dH/dT of an oscillation at T.
struct Swing {
  double H = 0.0;
  double V = 0.0;
};

Swing exact(double T) { return {std::cos(w * T), -w * std::sin(w * T)}; }

/// The pair on a spring, where the formula has weight [1/T] of the new values and `old` of those before.
Swing step(double weight, const Swing& old, const FrequencyFit& fit) {
  // H = (beta - alpha weight) V/weight + rest;  (f weight + c) V + f old.V + w^2 H = 0
  const double of_V = fit.beta / weight - fit.alpha, rest = -(old.H + fit.alpha * old.V) / weight;
  const double V = -(fit.inertia * old.V + w * w * rest) / (fit.inertia * weight + fit.damping + w * w * of_V);
  return {of_V * V + rest, V};
}

TEST(FrequencyFit, oscillation_in_few_unequal_steps_is_exact) {
  const double period = 2.0 * std::numbers::pi / w;
  for (const double part : {0.02, 0.1, 0.2}) {
    const double dT = part * period, before = 0.6 * dT;
    const std::vector<double> times = {0.3 + before + dT, 0.3 + before, 0.3}, weights = slope_weights(times);
    const Swing first = exact(times[2]), second = exact(times[1]);
    const Swing old{weights[2] * first.H + weights[1] * second.H, weights[2] * first.V + weights[1] * second.V};
    const Swing next = step(weights[0], old, frequency_fit(w, slope_of_oscillation(w, times)));
    const Swing wanted = exact(times[0]);
    EXPECT_NEAR(next.H, wanted.H, 1e-12) << part;
    EXPECT_NEAR(next.V, wanted.V, 1e-12) << part;
  }
}

TEST(FrequencyFit, first_step_is_exact) {
  const double dT = 0.5;
  const Swing first = exact(0.3), wanted = exact(0.8);
  const Swing next =
      step(1.0 / dT, {-first.H / dT, -first.V / dT}, frequency_fit(w, slope_of_oscillation(w, {dT, 0.0})));
  EXPECT_NEAR(next.H, wanted.H, 1e-12);
  EXPECT_NEAR(next.V, wanted.V, 1e-12);
}

TEST(FrequencyFit, short_steps_and_free_flight_need_none) {
  const double dT = 1e-3;
  const FrequencyFit fit = frequency_fit(w, slope_of_oscillation(w, {2.0 * dT, dT, 0.0})),
                     free = frequency_fit(0.0, 0.0);
  EXPECT_NEAR(fit.inertia, 1.0 - std::pow(w * dT, 2) / 3.0, 1e-9);
  EXPECT_NEAR(fit.beta, 1.0 + std::pow(w * dT, 2) / 3.0, 1e-9);
  EXPECT_NEAR(fit.damping, -0.25 * w * std::pow(w * dT, 3), 1e-11);
  EXPECT_NEAR(fit.alpha, 0.25 * w * w * dT * dT * dT, 1e-13);
  EXPECT_EQ(free.inertia, 1.0);
  EXPECT_EQ(free.beta, 1.0);
  EXPECT_EQ(free.damping, 0.0);
  EXPECT_EQ(free.alpha, 0.0);
}

}  // namespace
}  // namespace gearfilm
