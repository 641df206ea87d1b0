// Teeth that bend, and flanks that are not perfect involutes, against tests/reference/teeth.json.
#include "gear/teeth.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "gear/involute.hpp"
#include "gear/iso_stiffness.hpp"
#include "gearfilm/error.hpp"
#include "teeth_reference.hpp"

namespace gearfilm {
namespace {

using teeth_case::reference;

SpurGearPair table3_pair() {
  const auto gear = [](int teeth, double outer_radius) {
    SpurGear result{.teeth = teeth, .outer_radius = outer_radius, .crowning = 0.131e-3};
    result.youngs_modulus = 206e9;
    result.poisson_ratio = 0.3;
    result.bore_radius = 0.02;
    return result;
  };
  SpurGearPair pair{.pinion = gear(28, 46.55e-3), .wheel = gear(43, 69.85e-3), .module_length = 3e-3};
  pair.pressure_angle = 20.0 * std::numbers::pi / 180.0;
  pair.centre_distance = 111e-3;
  pair.face_width = 20e-3;
  return pair;
}

std::array<GearCompliance, 2> gears_of(const SpurGearPair& pair, FoundationModel foundation) {
  const std::array<double, 2> x = profile_shifts(pair);
  return {GearCompliance(pair.pinion, pair, ToothProfile(pair.pinion, pair, x[0], "pinion"), foundation, "pinion"),
          GearCompliance(pair.wheel, pair, ToothProfile(pair.wheel, pair, x[1], "wheel"), foundation, "wheel")};
}

Relief relief(double amount, double length, ReliefShape shape) {
  return {.amount = amount, .length = length, .shape = shape};
}

Teeth teeth_with(const GearFlanks& pinion, const GearFlanks& wheel, const ComplianceOptions& compliance = {}) {
  const SpurGearPair pair = table3_pair();
  return {pair, LineOfAction(pair), {pinion, wheel}, compliance};
}

TEST(ToothProfile, is_that_of_the_generating_rack) {
  const auto& geometry = reference().at("geometry");
  const SpurGearPair pair = table3_pair();
  const std::array<double, 2> x = profile_shifts(pair);
  const std::array<GearCompliance, 2> gears = gears_of(pair, FoundationModel::weber);
  for (int gear = 0; gear < 2; ++gear) {
    const ToothProfile& profile = gears[gear].profile();
    const auto expect = [&](const char* name, double computed) {
      EXPECT_NEAR(computed / geometry.at(name)[gear].get<double>(), 1.0, 1e-5) << name << " of gear " << gear + 1;
    };
    expect("profile_shift", x[gear]);
    expect("tooth_thickness_on_reference_circle", profile.thickness());
    expect("root_radius", profile.root_radius());
    expect("root_half_angle", profile.root_half_angle());
    expect("root_form_radius", profile.form_radius());
    expect("hob_tip_radius", profile.hob_tip_radius());
  }
}

// Gear by gear: the pinion is soft at the exit, the wheel at the entry, and their sum hides a mix-up.
TEST(ToothCompliance, is_that_of_the_reference_part_by_part) {
  const SpurGearPair pair = table3_pair();
  const LineOfAction line(pair);
  const double tolerance = reference().at("tolerances").at("compliance");
  for (const FoundationModel foundation : {FoundationModel::weber, FoundationModel::sainsot}) {
    const std::array<GearCompliance, 2> gears = gears_of(pair, foundation);
    const char* name = foundation == FoundationModel::weber ? "foundation_weber" : "foundation_sainsot";
    for (const auto& row : reference().at("compliance")) {
      const double xi = row.at("xi");
      const std::array<double, 2> rho = {line.radius_pinion(xi), line.radius_wheel(xi)};
      for (int gear = 0; gear < 2; ++gear) {
        const auto& expected = row.at(gear == 0 ? "gear1" : "gear2");
        const ToothCompliance tooth = gears[gear].tooth(rho[gear]);
        EXPECT_NEAR(tooth.bending / expected.at("bending").get<double>(), 1.0, tolerance) << xi;
        EXPECT_NEAR(tooth.shear / expected.at("shear").get<double>(), 1.0, tolerance) << xi;
        EXPECT_NEAR(tooth.axial / expected.at("axial").get<double>(), 1.0, tolerance) << xi;
        EXPECT_NEAR(tooth.foundation / expected.at(name).get<double>(), 1.0, tolerance) << xi;
      }
    }
  }
}

TEST(Teeth, of_the_pair_and_their_bodies_give_way_together) {
  const double tolerance = reference().at("tolerances").at("compliance");
  const Teeth teeth = teeth_with({}, {}, {.teeth = FoundationModel::weber});
  ASSERT_FALSE(teeth.rigid());
  for (const auto& row : reference().at("compliance")) {
    EXPECT_NEAR(teeth.compliance(row.at("xi")) / row.at("tooth_pair_with_body").get<double>(), 1.0, tolerance);
  }
  const auto& neighbour = reference().at("neighbour_coupling");
  const double coupling = neighbour[0].get<double>() + neighbour[1].get<double>();
  EXPECT_NEAR(teeth.coupling(1) / coupling, 1.0, tolerance);
  EXPECT_LT(teeth.coupling(2), teeth.coupling(1));
  EXPECT_EQ(teeth_with({}, {}, {.teeth = FoundationModel::weber, .body_coupling = false}).coupling(1), 0.0);
  EXPECT_TRUE(Teeth().rigid());
  const auto& iso = reference().at("stiffness").at("iso_6336_c_th_c_prime_c_gamma_N_per_mm_um");
  const SpurGearPair pair = table3_pair();
  const IsoStiffness computed = iso_stiffness(pair, LineOfAction(pair).contact_ratio());
  EXPECT_NEAR(computed.single / pair.face_width * 1e-9 / iso[1].get<double>(), 1.0, 1e-4);
  EXPECT_NEAR(computed.mesh / pair.face_width * 1e-9 / iso[2].get<double>(), 1.0, 1e-4);
}

TEST(Teeth, add_the_compliance_of_shafts_to_their_own_and_to_each_other) {
  const Teeth shafts = teeth_with({}, {}, {.mesh = 1e-9});
  EXPECT_NEAR(shafts.compliance(1e-3), 1e-9, 1e-20);
  EXPECT_DOUBLE_EQ(shafts.coupling(1), 1e-9);
  const Teeth tabulated = teeth_with({}, {}, {.table = {{-6e-3, 2e-9}, {0.0, 1e-9}, {6e-3, 3e-9}}, .mesh = 1e-10});
  EXPECT_NEAR(tabulated.compliance(-3e-3), 1.6e-9, 1e-15);
  EXPECT_NEAR(tabulated.compliance(3e-3), 2.1e-9, 1e-15);
}

TEST(Flank, has_its_reliefs_where_they_belong) {
  const double tip = 0.025, start = 0.012, length = 2e-3;
  for (const ReliefShape shape : {ReliefShape::linear, ReliefShape::parabolic, ReliefShape::smooth}) {
    FlankModification modification;
    modification.tip = relief(60e-6, length, shape);
    modification.root = relief(20e-6, length, shape);
    const Flank flank(modification, start, tip);
    EXPECT_NEAR(flank.removed(tip), 60e-6, 1e-18);
    EXPECT_NEAR(flank.removed(start), 20e-6, 1e-18);
    EXPECT_EQ(flank.removed(0.5 * (start + tip)), 0.0);
    const double half = shape == ReliefShape::parabolic ? 0.25 : 0.5;
    EXPECT_NEAR(flank.removed(tip - 0.5 * length), half * 60e-6, 1e-16);
  }
  const Flank inclined({.tip = {}, .root = {}, .slope = 8e-6, .crowning = 4e-6, .curves = {}}, start, tip);
  EXPECT_NEAR(inclined.removed(start), 4e-6, 1e-18);
  EXPECT_NEAR(inclined.removed(0.5 * (start + tip)), 4e-6, 1e-18);
  EXPECT_NEAR(inclined.removed(tip), 12e-6, 1e-18);
}

TEST(Flank, follows_a_measured_table_without_overshooting) {
  FlankModification measured;
  measured.curves = {{{0.012, 0.0}, {0.015, 0.0}, {0.018, 5e-6}, {0.021, 5e-6}, {0.024, 20e-6}}};
  const Flank flank(measured, 0.012, 0.024);
  double before = 0.0;
  for (int n = 0; n <= 240; ++n) {
    const double removed = flank.removed(0.012 + 5e-5 * n);
    EXPECT_GE(removed, before - 1e-18);
    before = removed;
  }
  EXPECT_NEAR(flank.removed(0.018), 5e-6, 1e-18);
  EXPECT_EQ(flank.removed(0.03), 20e-6);
}

TEST(Teeth, have_the_relief_of_a_gear_at_its_own_end) {
  const LineOfAction line(table3_pair());
  GearFlanks relieved;
  relieved.modification.tip = relief(60e-6, 2e-3, ReliefShape::parabolic);
  const Teeth pinion = teeth_with(relieved, {}), wheel = teeth_with({}, relieved);
  EXPECT_NEAR(pinion.gap(0, line.exit()), 60e-6, 1e-15);
  EXPECT_EQ(pinion.gap(0, line.entry()), 0.0);
  EXPECT_NEAR(wheel.gap(0, line.entry()), 60e-6, 1e-15);
  EXPECT_EQ(wheel.gap(0, line.exit()), 0.0);
}

TEST(Teeth, with_pitch_errors_stand_proud_once_a_turn) {
  GearFlanks bad;
  bad.pitch_errors.assign(28, 0.0);
  bad.pitch_errors[3] = 5e-6;
  const Teeth teeth = teeth_with(bad, {});
  EXPECT_DOUBLE_EQ(teeth.gap(3, 0.0), -5e-6);
  EXPECT_DOUBLE_EQ(teeth.gap(31, 0.0), -5e-6);
  EXPECT_DOUBLE_EQ(teeth.gap(-25, 0.0), -5e-6);
  EXPECT_EQ(teeth.gap(4, 0.0), 0.0);
  EXPECT_EQ(teeth.pattern(), 28);
  GearFlanks other;
  other.pitch_errors.assign(43, 0.0);
  EXPECT_EQ(teeth_with(bad, other).pattern(), 1204);
}

void expect_refused(const std::function<void()>& make, const std::string& word) {
  try {
    make();
    ADD_FAILURE() << "not refused: " << word;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(word));
  }
}

TEST(Teeth, that_cannot_be_are_refused) {
  GearFlanks flanks;
  flanks.modification.tip = relief(60e-6, 20e-3, ReliefShape::linear);
  expect_refused([&] { teeth_with(flanks, {}); }, "pinion_tip_relief_length");
  flanks = {};
  flanks.pitch_errors.assign(27, 0.0);
  expect_refused([&] { teeth_with({}, flanks); }, "wheel_pitch_errors");
  const auto with = [](auto change, FoundationModel foundation) {
    SpurGearPair pair = table3_pair();
    change(pair);
    Teeth(pair, LineOfAction(pair), {}, {.teeth = foundation});
  };
  const auto weber = FoundationModel::weber, ring = FoundationModel::sainsot;
  expect_refused([&] { with([](SpurGearPair& pair) { pair.pinion.root_radius = 43e-3; }, weber); },
                 "pinion_root_radius");
  expect_refused([&] { with([](SpurGearPair& pair) { pair.wheel.bore_radius = 64e-3; }, weber); }, "wheel_bore_radius");
  expect_refused([&] { with([](SpurGearPair& pair) { pair.pinion.bore_radius.reset(); }, ring); },
                 "pinion_bore_radius");
  expect_refused([&] { teeth_with({}, {}, {.teeth = weber, .factor = 0.05}); }, "body_coupling");
}

// From the pinion's tooth one comes to a reverse flank, from the wheel's to the same, but for the backlash between
// them.
TEST(BackFlanks, are_where_both_gears_teeth_end) {
  SpurGearPair pair = table3_pair();
  const LineOfAction line(pair);
  for (const double backlash : {0.0, 100e-6}) {
    pair.backlash = backlash;
    const Teeth teeth(pair, line, {}, {});
    const std::array<double, 2> x = profile_shifts(pair);
    const double alpha = pair.pressure_angle, working = line.working_pressure_angle();
    const double thickness = 0.5 * std::numbers::pi * pair.module_length +
                             2.0 * x[1] * pair.module_length * std::tan(alpha) - 0.5 * backlash / std::cos(alpha);
    const double of_wheel = 2.0 * line.base_radius_wheel() *
                            (thickness / (pair.wheel.teeth * pair.module_length) + involute(alpha) - involute(working));
    const double xi = 0.7e-3;
    const std::vector<double> positions = teeth.back_positions(xi);
    ASSERT_FALSE(positions.empty());
    for (const double position : positions) {
      EXPECT_GE(position, line.entry());
      EXPECT_LE(position, line.exit());
      const double pitches = (position + xi + of_wheel + backlash) / line.base_pitch();
      EXPECT_NEAR(pitches, std::round(pitches), 1e-9);
    }
    EXPECT_NEAR(static_cast<double>(positions.size()), line.contact_ratio(), 1.0);
    // They move backwards.
    const std::vector<double> later = teeth.back_positions(xi + 1e-6);
    EXPECT_NEAR(later.front(), positions.front() - 1e-6, 1e-12);
  }
}

TEST(LocalProfile, is_what_flanks_lack_beside_a_contact) {
  const SpurGearPair pair = table3_pair();
  const LineOfAction line(pair);
  GearFlanks relieved;
  relieved.modification.tip = {65e-6, 2.9e-3, ReliefShape::parabolic};
  EXPECT_FALSE(Teeth(pair, line, {relieved, {}}, {}).local(5e-3).flanks);
  const Teeth teeth(pair, line, {relieved, {}}, {}, ProfileAction::field);
  const double xi = 4.5e-3, rho = line.radius_pinion(xi);
  const LocalProfile local = teeth.local(xi);
  const double into = rho - (line.radius_pinion(line.exit()) - 2.9e-3), rate = line.base_radius_pinion() / rho;
  const auto removed = [](double u) { return 65e-6 * u * u / (2.9e-3 * 2.9e-3); };
  EXPECT_EQ(local(0.0), 0.0);
  // The inlet side of the pinion's flank is nearer to its tip.
  for (const double x : {-3e-4, 2e-4}) EXPECT_NEAR(local(x), removed(into - rate * x) - removed(into), 1e-12);
  EXPECT_GT(local(-3e-4), 0.0);
  EXPECT_EQ(teeth.local(-3e-3)(1e-4), 0.0);
}

// E = c (1 + rho/rho_0) (1 + y/w): c y/w (1 + rho/rho_0) more than in the middle.
TEST(UnevenProfile, is_what_flanks_lack_beside_the_middle_of_the_face) {
  const SpurGearPair pair = table3_pair();
  const LineOfAction line(pair);
  constexpr double c = 2e-6, rho_0 = 1e-2, w = 8e-3;
  const auto lacking = [](double rho, double y) { return c * (1.0 + rho / rho_0) * (1.0 + y / w); };
  const std::vector<double> places = {-w, 0.0, w};
  std::vector<FlankCurve> curves;
  for (const double y : places) {
    FlankCurve& curve = curves.emplace_back();
    for (const double rho : {1e-3, 8e-3, 30e-3, 60e-3}) curve.emplace_back(rho, lacking(rho, y));
  }
  GearFlanks worn;
  worn.modification.curves = {curves[1]};
  worn.beside_middle = UnevenFlank(places, curves);
  const double xi = 4.5e-3, x = 2e-4, rho = line.radius_wheel(xi);
  const std::vector<double> y = {-5e-3, 0.0, 7e-3, 9e-3}, within = {-5e-3, 0.0, 7e-3, w};
  EXPECT_FALSE(Teeth(pair, line, {}, {}).beside_middle(xi).flanks);
  for (const ProfileAction action : {ProfileAction::offset, ProfileAction::field}) {
    const Teeth teeth(pair, line, {GearFlanks(), worn}, {}, action);
    EXPECT_NEAR(teeth.gap(0, xi), lacking(rho, 0.0), 1e-15);
    const double along = action == ProfileAction::field ? x * line.base_radius_wheel() / rho : 0.0;
    const std::vector<double> gap = teeth.beside_middle(xi).gap(x, y);
    for (std::size_t n = 0; n < y.size(); ++n)
      EXPECT_NEAR(gap[n], lacking(rho + along, within[n]) - lacking(rho + along, 0.0), 1e-15);
  }
}

}  // namespace
}  // namespace gearfilm
