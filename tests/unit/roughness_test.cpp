// Statistics of rough surfaces against closed forms and the numbers of tests/reference/rough.json.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "roughness/archard.hpp"
#include "roughness/height_integrals.hpp"
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

TEST(AsperityLaw, falls_everywhere_and_has_its_slope) {
  AsperityOptions of_table{.kind = AsperityLawKind::table, .table_z = {-2, 0, 1, 3}, .table_p = {2e9, 3e8, 5e7, 1e4}};
  for (const AsperityOptions& options :
       {AsperityOptions{}, AsperityOptions{.kind = AsperityLawKind::exponential}, of_table}) {
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

}  // namespace
}  // namespace gearfilm
