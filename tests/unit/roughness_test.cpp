// Statistics of rough surfaces against closed forms and the numbers of tests/reference/rough.json.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "roughness/archard.hpp"
#include "roughness/contact_texture.hpp"
#include "roughness/height_integrals.hpp"
#include "roughness/measured_profile.hpp"
#include "roughness/rough_surfaces.hpp"

namespace gearfilm {
namespace {

constexpr double modulus = 206e9 / 0.91;  // E'
constexpr double closed_form = 1e-9;      // values are printed with more digits
constexpr double slope_error = 1e-6;      // of central differences

const nlohmann::json& rough_reference() {
  static const nlohmann::json numbers =
      nlohmann::json::parse(std::ifstream(std::string(GEARFILM_REFERENCE_DIR) + "/rough.json"));
  return numbers;
}

void expect_near(double found, double expected, double relative) {
  EXPECT_NEAR(found, expected, relative * std::abs(expected));
}

/// slope() is the derivative of value() at z.
template <class Function>
void expect_slope(Function function, double z, double relative = slope_error) {
  constexpr double step = 1e-5;
  const double difference = (function(z + step).value - function(z - step).value) / (2.0 * step);
  EXPECT_NEAR(function(z).slope, difference, relative * std::abs(difference) + 1e-12) << "at z = " << z;
}

TEST(HeightIntegrals, are_those_of_gaussian_heights) {
  for (const auto& [name, value] : rough_reference().at("height_integrals").items()) {
    const std::size_t open = name.find('(');
    const double n = std::stod(name.substr(2, open - 2)), u = std::stod(name.substr(open + 1));
    expect_near(height_integral(n, u), value, closed_form);
  }
}

TEST(MeanGap, is_positive_and_has_its_slope) {
  for (const auto& [z, value] : rough_reference().at("mean_gap").items()) {
    expect_near(gaussian_mean_gap(std::stod(z)).value, value, closed_form);
  }
  for (double z = -9.0; z < 9.0; z += 0.5) {
    EXPECT_GT(gaussian_mean_gap(z).value, 0.0);
    expect_slope(gaussian_mean_gap, z, 1e-5);
  }
}

// The limit of phi_x = 0.1 is found to other digits there.
TEST(ConductingGap, is_that_of_the_table_and_goes_on_below_it) {
  for (const auto& [lay, expected] : rough_reference().at("conductance").items()) {
    const ConductingGap gap(std::stod(lay) < 0.2 ? 1.0 / std::round(1.0 / std::stod(lay)) : std::stod(lay));
    for (const auto& [z, conductance] : expected.at("at").items()) {
      expect_near(std::pow(gap(std::stod(z)).value, 3), conductance, 3e-3);
    }
  }
}

TEST(ConductingGap, has_its_slope_at_any_lay) {
  for (const double lay : {1.0 / 9.0, 0.2, 0.5, 1.0, 2.0, 5.0, 9.0}) {
    const ConductingGap gap(lay);
    for (double z = -3.03; z < 20.0; z += 0.47) expect_slope(gap, z, 1e-5);
    EXPECT_NEAR(gap(1e12).value, 1e12, 1e3);  // a smooth gap
  }
}

TEST(ConductingGap, leads_more_oil_along_the_lay) {
  for (double z = 0.8; z < 5.0; z += 0.4) {
    EXPECT_LT(ConductingGap(1.0 / 3.0)(z).value, ConductingGap(1.0)(z).value);
    EXPECT_LT(ConductingGap(1.0)(z).value, ConductingGap(3.0)(z).value);
  }
}

TEST(ShearFlow, is_that_of_the_table) {
  for (const auto& [lay, expected] : rough_reference().at("shear_flow").items()) {
    const ShearFlow flow(std::stod(lay) < 0.2 ? 1.0 / std::round(1.0 / std::stod(lay)) : std::stod(lay));
    for (const auto& [z, value] : expected.items()) expect_near(flow(std::stod(z)).value, value, 1e-4);
    for (double z = 0.1; z < 8.0; z += 0.37) expect_slope(flow, z, 1e-5);
  }
}

RoughSurfaces surfaces(double first, double second, double lay_1 = 1.0, double lay_2 = 1.0) {
  return {{.roughness = {first, second}, .lay = {lay_1, lay_2}}, modulus};
}

TEST(ShearFlow, of_equal_flanks_is_none_and_changes_its_sign_with_them) {
  EXPECT_FALSE(surfaces(1e-6, 1e-6).has_shear_flow());
  const RoughSurfaces rough_first = surfaces(2e-6, 1e-6, 0.5, 2.0), rough_second = surfaces(1e-6, 2e-6, 2.0, 0.5);
  for (double z = 0.1; z < 6.0; z += 0.7) {
    EXPECT_GT(rough_first.shear_flow(z).value, 0.0);
    EXPECT_DOUBLE_EQ(rough_first.shear_flow(z).value, -rough_second.shear_flow(z).value);
  }
}

TEST(RoughSurfaces, have_their_functions_in_a_table) {
  const RoughSurfaces both = surfaces(2e-6, 1e-6, 0.5, 2.0);
  for (double z = -7.03; z < 200.0; z += z < 14.0 ? 0.031 : 1.7) {
    const GapValues at = both.at(z);
    expect_near(at.pressure, z < 12.0 ? both.asperities()(z).pressure : 0.0, 1e-6);
    EXPECT_NEAR(at.mean.value, gaussian_mean_gap(z).value, 1e-7);
    expect_near(at.along.value, both.conducting_along(z).value, 1e-4);
    expect_near(at.across.value, both.conducting_across(z).value, 1e-4);
    // It begins with a power at 0, and its branches do not quite meet at 5.
    const double tolerance = z >= 0.0 && z <= 0.1 ? 0.2 : z >= 4.95 && z <= 5.05 ? 5e-3 : 2e-5;
    EXPECT_NEAR(at.shear.value, both.shear_flow(z).value, tolerance);
  }
}

AsperityLaw law_named(const std::string& name) {
  AsperityOptions options{.hardness = 6e9, .summit_shift = false};
  if (name == "greenwood_tripp") options.kind = AsperityLawKind::greenwood_tripp;
  if (name == "greenwood_williamson") options.kind = AsperityLawKind::greenwood_williamson;
  if (name == "zhao_maietta_chang") options.summit_shift = true;
  return {options, modulus};
}

TEST(AsperityLaw, has_the_pressures_of_the_reference) {
  for (const auto& [name, values] : rough_reference().at("asperity_pressure").items()) {
    const double tolerance = name == "zhao_maietta_chang" ? 1e-3 : 1e-6;  // of its quadrature
    for (const auto& [z, pressure] : values.items()) {
      expect_near(law_named(name)(std::stod(z)).pressure, pressure, tolerance);
    }
  }
}

// Without a shift and with infinite hardness summits are those of Greenwood and Williamson.
TEST(AsperityLaw, of_hard_summits_is_the_elastic_one) {
  const AsperityLaw hard({.hardness = 1e15, .summit_shift = false}, modulus),
      elastic({.kind = AsperityLawKind::greenwood_williamson, .summit_shift = false}, modulus);
  for (double z = -3.0; z < 4.0; z += 0.5) expect_near(hard(z).pressure, elastic(z).pressure, 1e-5);
}

// Elastic summits of equal radii touch on pi beta d, plastic ones on twice that; F_2(0) = 1/2.
TEST(AsperityLaw, says_on_what_part_of_the_surface_summits_touch) {
  const AsperityLaw hard({.hardness = 1e15, .summit_shift = false}, modulus),
      soft({.hardness = 1e3, .summit_shift = false}, modulus),
      elastic({.kind = AsperityLawKind::greenwood_williamson, .summit_shift = false}, modulus);
  for (double z = -3.0; z < 4.0; z += 0.5) {
    expect_near(*hard.real_area(z), *elastic.real_area(z), 1e-5);
    expect_near(*soft.real_area(z), std::min(1.0, 2.0 * *elastic.real_area(z)), 1e-5);
  }
  const double product = std::numbers::pi * AsperityOptions().density_product;
  expect_near(*law_named("greenwood_tripp").real_area(0.0), 0.5 * product * product, 1e-9);
  EXPECT_FALSE(AsperityLaw({.kind = AsperityLawKind::exponential}, modulus).real_area(0.0));
}

TEST(AsperityLaw, falls_everywhere_and_has_its_slope) {
  AsperityOptions of_table{.kind = AsperityLawKind::table, .table_z = {-2, 0, 1, 3}, .table_p = {2e9, 3e8, 5e7, 1e4}};
  for (const AsperityOptions& options : {AsperityOptions{}, AsperityOptions{.kind = AsperityLawKind::greenwood_tripp},
                                         AsperityOptions{.kind = AsperityLawKind::greenwood_williamson},
                                         AsperityOptions{.kind = AsperityLawKind::exponential}, of_table}) {
    const AsperityLaw law(options, modulus);
    for (double z = -12.0; z < 12.0; z += 0.173) {
      const AsperityLaw::Value value = law(z);
      EXPECT_GT(value.pressure, 0.0);
      EXPECT_LT(value.slope, 0.0);
      expect_slope(
          [&](double at) {
            return GapFunction{std::log(law(at).pressure), law(at).slope / law(at).pressure};
          },
          z);
      EXPECT_NEAR(law.gap_under(value.pressure), z, 1e-9);
    }
  }
}

TEST(Wear, is_zero_without_sliding_and_larger_on_the_slower_flank) {
  EXPECT_EQ(wear_depth(1e-16, 0.0, 3.0, 1e5), 0.0);
  const double fast = wear_depth(1e-16, 1.0, 3.5, 1e5), slow = wear_depth(1e-16, -1.0, 2.5, 1e5);
  EXPECT_DOUBLE_EQ(slow / fast, 3.5 / 2.5);
  EXPECT_DOUBLE_EQ(wear_depth(2e-16, 1.0, 3.5, 1e5), 2.0 * fast);
}

constexpr double length = 0.2e-3, height = 0.3e-6;  // of waves [m]

HeightProfile sampled_wave(double step, int points) {
  HeightProfile profile{.begin = 1e-3, .step = step, .heights = {}};
  for (int k = 0; k < points; ++k)
    profile.heights.push_back(height * std::cos(2.0 * std::numbers::pi * (1e-3 + k * step) / length));
  return profile;
}

TEST(Topography, has_the_heights_and_slopes_of_its_waves) {
  const Topography wavy(Waviness{height, length, 0.5}, {}, {}, 1.0);
  EXPECT_NEAR(wavy.along(0.0).value, height * std::cos(0.5), 1e-15);
  const auto at = [&](double s) { return GapFunction{wavy.along(s).value, wavy.along(s).slope}; };
  for (const double s : {0.01e-3, 0.06e-3, 5.13e-3}) {
    constexpr double step = 1e-9;
    EXPECT_NEAR(at(s).slope, (at(s + step).value - at(s - step).value) / (2.0 * step), 1e-6);
  }
  EXPECT_FALSE(wavy.varies_across());
}

// Between points of a wave the spline errs by the fourth power of their distance.
TEST(Topography, goes_through_the_heights_of_a_profile) {
  double before = 0.0;
  for (const int points : {10, 20}) {
    const Topography measured({}, {}, sampled_wave(length / points, 10 * points), 1.0);
    double largest = 0.0;
    for (double s = 1.4e-3; s < 2.4e-3; s += 7e-6) {
      const double wave = height * std::cos(2.0 * std::numbers::pi * s / length);
      largest = std::max(largest, std::abs(measured.along(s).value - wave));
    }
    EXPECT_LT(largest, 0.02 * height);
    if (before > 0.0) {
      EXPECT_NEAR(before / largest, 16.0, 3.0);
    }
    before = largest;
  }
  const Topography measured({}, {}, sampled_wave(length / 20, 200), 1.0);
  EXPECT_EQ(measured.along(0.5e-3).value, 0.0);
  EXPECT_EQ(measured.along(9e-3).value, 0.0);
}

TEST(ContactTexture, carries_the_heights_of_either_flank_towards_the_outlet) {
  const auto flanks = std::make_shared<const std::array<Topography, 2>>(std::array{
      Topography(Waviness{height, length, 0.0}, {}, {}, 1.0), Topography(Waviness{height, length, 0.0}, {}, {}, 1.0)});
  constexpr double travelled = 0.03e-3, x = 0.01e-3;
  const ContactTexture before{flanks, {5e-3, 3e-3}}, after{flanks, {5e-3 + travelled, 3e-3 - travelled}};
  for (std::size_t flank : {0, 1}) {
    EXPECT_NEAR(after.along(x + travelled)[flank].value, before.along(x)[flank].value, 1e-18);
    EXPECT_NEAR(after.along(x + travelled)[flank].slope, before.along(x)[flank].slope, 1e-12);
    EXPECT_NEAR(before.along(x)[flank].slope,
                (before.along(x + 1e-9)[flank].value - before.along(x - 1e-9)[flank].value) / 2e-9, 1e-6);
  }
}

TEST(MeasuredProfile, is_split_in_halves_at_the_cutoff_and_loses_its_form) {
  std::vector<std::pair<double, double>> points;
  for (int k = 0; k <= 2000; ++k) {
    const double s = 1e-3 + 2e-6 * k, v = k / 1000.0 - 1.0;
    points.emplace_back(s, height * std::cos(2.0 * std::numbers::pi * s / length) + 1e-6 + 2e-6 * v + 3e-6 * v * v);
  }
  const SplitProfile split = split_profile(points, length);
  EXPECT_NEAR(split.form, 3e-6, 0.01e-6);
  EXPECT_NEAR(split.rms, height / std::sqrt(2.0), 0.01 * height);
  EXPECT_NEAR(split.resolved_rms / split.rms, 0.5, 0.01);  // a wave as long as the cutoff
  EXPECT_NEAR(split.shorter_rms / split.rms, 0.5, 0.01);
  EXPECT_NEAR(split_profile(points, length / 20.0).resolved_rms / split.rms, 1.0, 0.01);
  EXPECT_EQ(split.resolved.heights.front(), 0.0);
}

}  // namespace
}  // namespace gearfilm
