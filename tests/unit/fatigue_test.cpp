// Smallest balls, Dang Van's criterion, risk and the profiles of materials.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>
#include <random>

#include "damage_reference.hpp"
#include "fatigue/dang_van.hpp"
#include "fatigue/flank_path.hpp"
#include "fatigue/material_profile.hpp"
#include "fatigue/risk.hpp"
#include "stress/stress_depths.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;
using Points = std::vector<DeviatorPoint>;

TEST(SmallestBall, of_the_corners_of_a_simplex_is_their_circumsphere) {
  Points corners{DeviatorPoint::Zero()};
  for (int n = 0; n < 5; ++n) corners.push_back(DeviatorPoint::Unit(n));
  // |c - e_n| = |c| leaves c_n = 1/2, outside of the hull: the ball of the five unit vectors holds the corner at 0.
  const Ball ball = smallest_ball(corners);
  EXPECT_NEAR((ball.centre - DeviatorPoint::Constant(0.2)).norm(), 0.0, 1e-10);
  EXPECT_NEAR(ball.radius, std::sqrt(0.8), 1e-10);
}

TEST(SmallestBall, of_two_points_and_of_one) {
  DeviatorPoint a, b;
  a << 1, 2, 3, 4, 5;
  b << -1, 0, 3, 8, 5;
  EXPECT_NEAR((smallest_ball(Points{a, b}).centre - 0.5 * (a + b)).norm(), 0.0, 1e-10);
  EXPECT_EQ(smallest_ball(Points{a, a, a}).radius, 0.0);
}

TEST(SmallestBall, of_a_circle_in_a_plane_is_the_circle_s) {
  DeviatorPoint first, second, centre;
  first << 1, 1, 0, 0, 0;
  second << 0, 0, 2, 0, 1;
  centre << 3, 0, -1, 0, 2;
  first.normalize();
  second.normalize();
  Points circle;
  for (int n = 0; n < 500; ++n) {
    const double angle = 2.0 * pi * n / 500;
    circle.emplace_back(centre + 2.0 * (std::cos(angle) * first + std::sin(angle) * second));
  }
  const Ball ball = smallest_ball(circle);
  EXPECT_NEAR((ball.centre - centre).norm(), 0.0, 1e-10);
  EXPECT_NEAR(ball.radius, 2.0, 1e-10);
}

/// By how much the centre lies outside of the hull of the points on the ball's surface: of the best convex combination,
/// by projected least squares on all of them.
double distance_from_hull(const Ball& ball, const Points& points) {
  Points on_surface;
  for (const DeviatorPoint& point : points) {
    if ((point - ball.centre).norm() >= ball.radius * (1.0 - 1e-9)) on_surface.push_back(point);
  }
  Eigen::MatrixXd system(6, on_surface.size());
  Eigen::VectorXd right(6);
  for (std::size_t n = 0; n < on_surface.size(); ++n) system.col(n) << on_surface[n], 1.0;
  right << ball.centre, 1.0;
  const Eigen::VectorXd weights = system.completeOrthogonalDecomposition().solve(right);
  return std::max((system * weights - right).norm(), std::max(0.0, -weights.minCoeff()));
}

// Optimal is the ball that holds all points and whose centre lies in the hull of those on its surface.
TEST(SmallestBall, of_random_points_is_optimal) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int set = 0; set < 200; ++set) {
    Points points(5 + 3 * set);
    for (DeviatorPoint& point : points) {
      for (double& value : point) value = normal(random);
    }
    const Ball ball = smallest_ball(points);
    for (const DeviatorPoint& point : points) EXPECT_LE((point - ball.centre).norm(), ball.radius * (1.0 + 1e-9));
    EXPECT_LT(distance_from_hull(ball, points), 1e-10) << set;
  }
}

TEST(Deviator, has_the_norm_of_the_stress_deviator) {
  const Stress t{1.0, -2.0, 0.5, 0.3, -0.7, 1.1};
  EXPECT_NEAR(deviator(t).norm(), von_mises(t) * std::sqrt(2.0 / 3.0), 1e-14);
}

TEST(DangVan, is_the_limit_of_torsion_in_reversed_bending_and_torsion) {
  constexpr double bending = 700.0, torsion = 420.0;
  const DangVanOptions options{.alpha = 3.0 * (torsion / bending - 0.5)};
  std::vector<Stress> bent, twisted, pulled;
  for (int n = 0; n <= 40; ++n) {
    const double wave = std::sin(2.0 * pi * n / 40);
    bent.push_back({.xx = bending * wave});
    twisted.push_back({.xy = torsion * wave});
    pulled.push_back({.xx = 0.5 + 0.5 * wave});
  }
  EXPECT_NEAR(dang_van(bent, options), torsion, 1e-9 * torsion);
  EXPECT_NEAR(dang_van(twisted, options), torsion, 1e-9 * torsion);
  EXPECT_NEAR(dang_van(pulled, {.alpha = 0.3}), damage_number("dv_pulsating_tension_0_1_alpha.3"), 1e-9);
}

/// The row at a depth as history, with the unloaded state.
std::vector<Stress> line_history(double z, double residual = 0.0, int to_a_half_width = 40) {
  const Stress constant{.xx = residual, .yy = residual};
  std::vector<Stress> history{constant};
  for (int n = -5 * to_a_half_width; n <= 5 * to_a_half_width; ++n) {
    history.push_back(line_contact_stress(static_cast<double>(n) / to_a_half_width, z) + constant);
  }
  history.push_back(constant);
  return history;
}

TEST(DangVan, of_a_rolling_line_contact_has_the_numbers_of_the_reference) {
  for (const auto& [name, alpha, z] : {std::tuple{"dv_line_alpha0.0_z0.500", 0.0, 0.5},
                                       {"dv_line_alpha0.2_z0.500", 0.2, 0.5},
                                       {"dv_line_alpha0.3_z0.500", 0.3, 0.5},
                                       {"dv_line_alpha0.4_z0.500", 0.4, 0.5},
                                       {"dv_line_alpha0.3_z0.786", 0.3, damage_number("line_tau_max_depth")}}) {
    EXPECT_NEAR(dang_van(line_history(z), {.alpha = alpha}), damage_number(name), 0.01 * damage_number(name)) << name;
  }
  double largest = 0.0;
  for (double z = 0.4; z < 0.8; z += 0.02) largest = std::max(largest, dang_van(line_history(z), {.alpha = 0.3}));
  EXPECT_NEAR(largest, damage_number("dv_line_alpha.3_max"), 0.01 * largest);
}

TEST(DangVan, is_shifted_by_residual_stress) {
  for (const double residual : {-0.3, 0.2}) {
    EXPECT_NEAR(dang_van(line_history(0.5, residual), {.alpha = 0.3}),
                dang_van(line_history(0.5), {.alpha = 0.3}) + 0.3 * 2.0 / 3.0 * residual, 1e-12);
  }
  const double loaded = dang_van(line_history(0.5), {.alpha = 0.3});
  EXPECT_NEAR(dang_van_safety(loaded, 0.3, -0.3, 0.3), (0.3 + 0.06) / loaded, 1e-14);
}

TEST(DangVan, without_the_gain_of_compression_is_larger) {
  EXPECT_NEAR(dang_van(line_history(0.5), {.alpha = 0.3, .compression_helps = false}),
              dang_van(line_history(0.5), {.alpha = 0.0}), 1e-12);  // nothing is in tension there
}

// 1 % at 6 states to a half-width with cubic interpolation between them, where it is 4 % without.
TEST(DangVan, of_few_states_is_mended_by_resampling) {
  const double fine = dang_van(line_history(0.6, 0.0, 80), {.alpha = 0.3});
  const std::vector<Stress> coarse = line_history(0.6, 0.0, 12);
  std::vector<double> times;
  for (std::size_t n = 0; n < coarse.size(); ++n) times.push_back(static_cast<double>(n));
  const std::vector<Stress> more = resampled(times, coarse, 4);
  EXPECT_EQ(more.size(), 4 * (coarse.size() - 1) + 1);
  EXPECT_NEAR(dang_van(more, {.alpha = 0.3}), fine, 0.007 * fine);
}

TEST(Resampling, goes_through_parabolas_of_unequal_steps) {
  const std::vector<double> times{0.0, 0.1, 0.5, 0.6, 1.3};
  std::vector<Stress> states;
  for (const double t : times) states.push_back({.xx = t * t, .xz = 1.0 - t});
  const std::vector<Stress> more = resampled(times, states, 4);
  for (std::size_t n = 4; n <= 12; ++n) {  // off both ends
    const double t = times[n / 4] + (n % 4) * 0.25 * (times[n / 4 + 1] - times[n / 4]);
    EXPECT_NEAR(more[n].xx, t * t, 1e-12);
    EXPECT_NEAR(more[n].xz, 1.0 - t, 1e-12);
  }
  EXPECT_EQ(resampled({}, {}, 4).size(), 0U);
}

SpurGearPair drawing(double centre_distance) {
  SpurGearPair pair;
  pair.module_length = 3e-3;
  pair.pressure_angle = 20.0 * pi / 180.0;
  pair.centre_distance = centre_distance;
  pair.face_width = 0.02;
  return pair;
}

LineOfAction unequal_gears() {
  SpurGearPair pair = drawing(0.0815);
  pair.pinion = {.teeth = 28, .outer_radius = 45.3e-3, .youngs_modulus = 206e9, .poisson_ratio = 0.3};
  pair.wheel = {.teeth = 26, .outer_radius = 42.3e-3, .youngs_modulus = 206e9, .poisson_ratio = 0.3};
  return LineOfAction(pair);
}

TEST(FlankPath, moves_material_by_rolling) {
  const LineOfAction line = unequal_gears();
  for (const bool pinion : {true, false}) {
    const FlankPath path(line, pinion);
    const double base = pinion ? line.base_radius_pinion() : line.base_radius_wheel();
    for (double xi = line.entry(); xi < line.exit(); xi += 1e-3) {
      const double s = path.arc_length(xi), d = 1e-6;
      EXPECT_NEAR(path.position_of(s), xi, 1e-12);
      EXPECT_NEAR(path.place(s, xi), 0.0, 1e-15);
      const double rate = (path.place(s, xi + d) - path.place(s, xi - d)) / (2.0 * d);
      EXPECT_NEAR(rate, path.curvature_radius(xi) / base, 1e-6);
      EXPECT_NEAR(path.curvature_radius(xi), pinion ? line.radius_pinion(xi) : line.radius_wheel(xi), 1e-12);
    }
    EXPECT_LT(path.lowest(), path.highest());
  }
}

TEST(FlankPath, of_equal_gears_is_the_same_the_other_way_round) {
  SpurGearPair pair = drawing(0.084);
  pair.pinion = pair.wheel = {.teeth = 28, .outer_radius = 45.0e-3, .youngs_modulus = 206e9, .poisson_ratio = 0.3};
  const LineOfAction line(pair);
  const FlankPath pinion(line, true), wheel(line, false);
  for (const double xi : {-3e-3, 0.0, 2e-3}) {
    EXPECT_NEAR(pinion.arc_length(xi), wheel.arc_length(-xi), 1e-12);
    EXPECT_NEAR(pinion.place(0.01, xi), -wheel.place(0.01, -xi), 1e-12);
  }
}

double line_risk(double pressure, const RiskOptions& options) {
  std::vector<double> depths, amplitudes;
  for (int n = 0; n <= 60; ++n) {
    const double z = 3.0 * n / 60;
    double largest = 0.0;
    for (double x = 0.0; x < 4.0; x += 2e-3) largest = std::max(largest, std::abs(line_contact_stress(x, z).xz));
    depths.push_back(z);
    amplitudes.push_back(pressure * largest);
  }
  return risk_of_depths(depths, amplitudes, options);
}

// A half-width grows with p_h, and so does the width of the stressed volume in a point contact.
TEST(Risk, of_line_and_point_contacts_goes_as_powers_of_pressure) {
  const double unit = line_risk(1.0, {}), expected = damage_number("lp_line_risk_orthogonal");
  EXPECT_NEAR(unit, expected, 3e-3 * expected);
  // I = Int dz (..)^c (z/a*)^-h = a (a/a*)^-h Int dz/a (..): a ~ p_h, and the width in y too.
  const RiskOptions options;
  const double p = 1.3, a = p;
  const double line = line_risk(p, options) * std::pow(a, 1.0 - options.depth_exponent) / unit, point = line * a;
  EXPECT_NEAR(std::log(line) / std::log(p), damage_number("lp_slope_line"), 1e-6);
  EXPECT_NEAR(std::log(point) / std::log(p), damage_number("lp_slope_point"), 1e-6);
  EXPECT_NEAR(life_ratio(2.0, 1.0, options), std::pow(0.5, 0.9), 1e-14);
  EXPECT_LT(line_risk(1.0, {.threshold = 0.1}), unit);
}

TEST(MaterialProfile, passes_550_at_the_case_depth) {
  FlankMaterial flank{.hardening = CaseHardening{700.0, 350.0, 0.8e-3}, .residual_of_hardness = true};
  EXPECT_NEAR(flank.hardness(0.0), 700.0, 1e-9);
  EXPECT_NEAR(flank.hardness(0.8e-3), 550.0, 1e-9);
  EXPECT_NEAR(flank.hardness(0.4e-3), damage_number("hardness_gauss_.4mm"), 1e-6);
  const auto& lang = damage_reference().at("residual_lang_HV350_core").at("value");
  EXPECT_NEAR(1e-6 * residual_stress_of_hardness(650.0, 350.0), lang[0].get<double>(), 1e-9);
  EXPECT_NEAR(1e-6 * residual_stress_of_hardness(650.0 + 1e-9, 350.0), lang[1].get<double>(), 1e-6);
  EXPECT_EQ(flank.known_to(), HUGE_VAL);
  flank.hardness_table = DepthTable{{0.0, 1e-3}, {720.0, 420.0}};
  EXPECT_NEAR(flank.hardness(0.5e-3), 570.0, 1e-9);
  EXPECT_EQ(flank.known_to(), 1e-3);
}

}  // namespace
}  // namespace gearfilm
