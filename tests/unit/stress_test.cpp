// Stresses beneath patches: reference numbers, Fourier's exact solution, equilibrium; what criteria make of a stress.
#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <numbers>
#include <random>

#include "algebra/dense.hpp"
#include "damage_reference.hpp"
#include "stress/first_yield.hpp"
#include "stress/patch_kernel.hpp"
#include "stress/stress_depths.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

void expect_components(const Stress& found, const nlohmann::json& expected, double tolerance) {
  const std::array<double, 6> values = found.components();
  for (std::size_t c = 0; c < values.size(); ++c) EXPECT_NEAR(values[c], expected[c].get<double>(), tolerance) << c;
}

TEST(PatchStress, has_the_numbers_of_the_reference) {
  const Strip strip{-0.2 - 0.35, -0.2 + 0.35};  // the place lies 0.2 above the patch's middle
  const auto value = [](const char* name) { return damage_reference().at(name).at("value"); };
  expect_components(patch_stress(SurfaceLoad::pressure, 0.5, 0.3, strip, 0.4, 0.3),
                    value("patch_p_dx.5_dy.2_z.4_hx.3_hy.7_nu.3"), 1e-12);
  expect_components(patch_stress(SurfaceLoad::shear_x, 0.5, 0.3, strip, 0.4, 0.3), value("patch_qx_same"), 1e-12);
  const Strip centred{-0.35, 0.35};
  expect_components(patch_stress(SurfaceLoad::pressure, 0.0, 0.3, centred, 0.0, 0.3), value("patch_p_centre_z0"),
                    1e-12);
  expect_components(patch_stress(SurfaceLoad::shear_x, 0.0, 0.3, centred, 0.0, 0.3), value("patch_qx_centre_z0"),
                    1e-12);
}

TEST(PatchStress, of_shear_across_is_that_along_x_turned) {
  const Stress along = patch_stress(SurfaceLoad::shear_x, 0.5, 0.3, {-0.55, 0.15}, 0.4, 0.28),
               across = patch_stress(SurfaceLoad::shear_y, 0.2, 0.7, {-0.65, -0.35}, 0.4, 0.28);
  EXPECT_NEAR(across.yy, along.xx, 1e-14);
  EXPECT_NEAR(across.xx, along.yy, 1e-14);
  EXPECT_NEAR(across.yz, along.xz, 1e-14);
  EXPECT_NEAR(across.xy, along.xy, 1e-14);
}

/// Transfer functions of Airy's and the torsion problem, xx yy zz yz xz xy, of a load at wave vector (kx, ky).
std::array<Complex, 6> transfer(SurfaceLoad load, double kx, double ky, double z, double nu) {
  const double k = std::hypot(kx, ky), c = kx / k, s = ky / k, e = std::exp(-k * z), kz = k * z;
  const double p = load == SurfaceLoad::pressure;
  const double q_l = load == SurfaceLoad::shear_x   ? c
                     : load == SurfaceLoad::shear_y ? s
                                                    : 0.0,
               q_t = load == SurfaceLoad::shear_x   ? -s
                     : load == SurfaceLoad::shear_y ? c
                                                    : 0.0;
  const Complex i(0.0, 1.0);
  const Complex ll = -(1.0 - kz) * e * p + i * (2.0 - kz) * e * q_l, tt = -2.0 * nu * e * p + 2.0 * i * nu * e * q_l,
                zz = -(1.0 + kz) * e * p + i * kz * e * q_l, lz = i * kz * e * p - (1.0 - kz) * e * q_l,
                lt = i * e * q_t, tz = -e * q_t;
  return {c * c * ll + s * s * tt - 2.0 * c * s * lt,
          s * s * ll + c * c * tt + 2.0 * c * s * lt,
          zz,
          s * lz + c * tz,
          c * lz - s * tz,
          c * s * (ll - tt) + (c * c - s * s) * lt};
}

TEST(TransferFunction, of_this_test_has_the_numbers_of_the_reference) {
  for (const auto& [load, name] : {std::pair{SurfaceLoad::pressure, "transfer_p_kx1.2_ky-0.7_z0.6_nu0.28"},
                                   {SurfaceLoad::shear_x, "transfer_qx_kx1.2_ky-0.7_z0.6_nu0.28"},
                                   {SurfaceLoad::shear_y, "transfer_qy_kx1.2_ky-0.7_z0.6_nu0.28"}}) {
    const auto found = transfer(load, 1.2, -0.7, 0.6, 0.28);
    const nlohmann::json& expected = damage_reference().at(name).at("value");
    for (std::size_t c = 0; c < found.size(); ++c) {
      EXPECT_NEAR(found[c].real(), expected[c][0].get<double>(), 1e-12) << name << c;
      EXPECT_NEAR(found[c].imag(), expected[c][1].get<double>(), 1e-12) << name << c;
    }
  }
}

/// Exact stresses beneath the load exp(-r^2/2): Fourier's integral in polar coordinates.
std::array<double, 6> beneath_gaussian(SurfaceLoad load, double x, double y, double z) {
  constexpr int angles = 64, steps = 400;
  constexpr double largest = 9.0, step = largest / steps;
  std::array<double, 6> sum{};
  for (int n = 1; n < steps; ++n) {
    const double k = n * step, weight = (n % 2 == 1 ? 4.0 : 2.0) * step / 3.0;  // Simpson's
    for (int m = 0; m < angles; ++m) {
      const double angle = 2.0 * pi * (m + 0.5) / angles, kx = k * std::cos(angle), ky = k * std::sin(angle);
      const Complex factor = std::exp(Complex(-0.5 * k * k, kx * x + ky * y)) * (weight * k / angles);
      const auto of = transfer(load, kx, ky, z, 0.3);
      for (std::size_t c = 0; c < 6; ++c) sum[c] += (of[c] * factor).real();
    }
  }
  return sum;
}

std::array<double, 6> beneath_gaussian_patches(SurfaceLoad load, double x, double y, double z, double h) {
  Stress sum;
  const int reach = static_cast<int>(std::lround(6.0 / h));
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      const double at_x = i * h, at_y = j * h, value = std::exp(-0.5 * (at_x * at_x + at_y * at_y));
      sum += value * patch_stress(load, x - at_x, h, {at_y - y - 0.5 * h, at_y - y + 0.5 * h}, z, 0.3);
    }
  }
  return sum.components();
}

// The load is constant on cells: errors are of second order in their size.
TEST(PatchStress, comes_to_fourier_s_solution_with_finer_patches) {
  for (const SurfaceLoad load : {SurfaceLoad::pressure, SurfaceLoad::shear_x, SurfaceLoad::shear_y}) {
    const auto exact = beneath_gaussian(load, 0.5, -1.0, 0.7),
               coarse = beneath_gaussian_patches(load, 0.5, -1.0, 0.7, 0.25),
               fine = beneath_gaussian_patches(load, 0.5, -1.0, 0.7, 0.125);
    for (std::size_t c = 0; c < 6; ++c) {
      EXPECT_NEAR(fine[c], exact[c], 2e-3) << c;
      if (std::abs(coarse[c] - exact[c]) < 1e-5) continue;  // of the integrals
      EXPECT_NEAR((coarse[c] - exact[c]) / (fine[c] - exact[c]), 4.0, 0.3) << c;
    }
  }
}

TEST(PatchStress, is_in_equilibrium) {
  constexpr double d = 1e-4;
  for (const SurfaceLoad load : {SurfaceLoad::pressure, SurfaceLoad::shear_x, SurfaceLoad::shear_y}) {
    for (const auto& [x, y, z] : {std::array{0.5, 0.2, 0.4}, {-0.8, 0.1, 0.3}, {0.1, -0.6, 0.9}, {-0.2, -0.9, 0.35}}) {
      const auto at = [&, x = x, y = y, z = z](double dx, double dy, double dz) {
        return patch_stress(load, x + dx, 0.3, {-0.35 - y - dy, 0.35 - y - dy}, z + dz, 0.3);
      };
      const Stress by_x = (0.5 / d) * (at(d, 0, 0) + -1.0 * at(-d, 0, 0)),
                   by_y = (0.5 / d) * (at(0, d, 0) + -1.0 * at(0, -d, 0)),
                   by_z = (0.5 / d) * (at(0, 0, d) + -1.0 * at(0, 0, -d));
      EXPECT_NEAR(by_x.xx + by_y.xy + by_z.xz, 0.0, 1e-6);
      EXPECT_NEAR(by_x.xy + by_y.yy + by_z.yz, 0.0, 1e-6);
      EXPECT_NEAR(by_x.xz + by_y.yz + by_z.zz, 0.0, 1e-6);
    }
  }
}

TEST(EquivalentStress, is_that_of_eigenvalues) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 200; ++n) {
    const Stress t{normal(random), normal(random), normal(random), normal(random), normal(random), normal(random)};
    Eigen::Matrix3d matrix;
    matrix << t.xx, t.xy, t.xz, t.xy, t.yy, t.yz, t.xz, t.yz, t.zz;
    const Eigen::VectorXd principal = symmetric_eigen_pairs(matrix, Eigen::Matrix3d::Identity()).values;
    EXPECT_NEAR(largest_principal(t), principal[2], 1e-12);
    EXPECT_NEAR(largest_shear_stress(t), 0.5 * (principal[2] - principal[0]), 1e-12);
    const double a = principal[0] - principal[1], b = principal[1] - principal[2], c = principal[2] - principal[0];
    EXPECT_NEAR(von_mises(t), std::sqrt(0.5 * (a * a + b * b + c * c)), 1e-12);
  }
  EXPECT_EQ(largest_shear_stress({.xx = 2.0, .yy = 2.0, .zz = 2.0}), 0.0);
}

TEST(StressDepths, lie_closer_at_the_surface_and_find_the_maximum_between_them) {
  const std::vector<double> depths = stress_depths(2.0, 24);
  EXPECT_EQ(depths.front(), 0.0);
  EXPECT_DOUBLE_EQ(depths.back(), 2.0);
  EXPECT_NEAR(depths[1], 0.018, 5e-4);
  std::vector<double> values;
  for (const double z : depths) values.push_back(von_mises(line_contact_stress(0.0, z)));
  const Peak peak = largest_between(depths, values);
  EXPECT_NEAR(peak.value, damage_number("line_von_mises_max_nu.3"), 1e-3);
  EXPECT_NEAR(peak.at, damage_number("line_von_mises_depth"), 0.02);
  EXPECT_THROW(largest_between(depths, values, 3.0), std::invalid_argument);
}

TEST(FirstYield, is_that_of_lines_and_circles_and_falls_between) {
  EXPECT_NEAR(first_yield_ratio(0.0), 1.0 / damage_number("line_von_mises_max_nu.3"), 1e-3);
  EXPECT_NEAR(first_yield_ratio(1.0), 1.0 / damage_number("circle_von_mises_max_nu.3"), 1e-3);
  for (double axes = 0.05; axes <= 1.0; axes += 0.05)
    EXPECT_LT(first_yield_ratio(axes), first_yield_ratio(axes - 0.05));
}

}  // namespace
}  // namespace gearfilm
