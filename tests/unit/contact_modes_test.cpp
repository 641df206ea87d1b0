// Modes of drive trains whose contact has a dynamic stiffness, against tests/reference/drivetrain.json.
#include "train/contact_modes.hpp"

#include <numbers>

#include "algebra/dense.hpp"
#include "gearfilm/error.hpp"
#include "train_reference.hpp"

namespace gearfilm::trains {
namespace {

using std::numbers::pi;

double ratio_of(std::complex<double> s) { return -s.real() / std::abs(s); }

/// k (1 + 4e-6 s)/(1 + 3.2e-6 s): a spring that stiffens, as films do.
std::complex<double> stand_in(std::complex<double> s, double) {
  return stiffness_of("weber_bores") * (1.0 + 4e-6 * s) / (1.0 + 3.2e-6 * s);
}

DampedTrain damped_line(double stiffness) {
  Train train = line_with_motor_and_load(true);
  train.add_bearing(1, bearing_of(stiffness, stiffness));
  train.add_bearing(2, bearing_of(stiffness, stiffness));
  return damped_train(train, {.stiffness = stiffness_of("weber_bores")}, 0.0);
}

TEST(ContactModes, are_those_of_the_reference) {
  const nlohmann::json& expected = reference().at("films_nep");
  const double tolerance_of_zeta = expected.at("tol").at("zeta");
  const DampedTrain train = damped_line(1e9);
  expect_frequencies(train.modes, reference().at("train8_iso_1e9").at("f"), 1e-6);
  for (std::size_t n = 0; n < train.modes.size(); ++n) {
    const std::complex<double> s = contact_mode(train, train.modes[n], stand_in);
    const double frequency = expected.at("f_zeta")[n][0], zeta = expected.at("f_zeta")[n][1];
    EXPECT_NEAR(s.imag() / (2.0 * pi), frequency, 1e-6 * frequency);
    EXPECT_NEAR(ratio_of(s), zeta, tolerance_of_zeta * zeta + 1e-12);
    // To first order by the share of the mesh.
    const double loss = stand_in({0.0, train.modes[n].rate}, 0.0).imag() / stiffness_of("weber_bores");
    EXPECT_NEAR(0.5 * train.modes[n].mesh_share * loss, zeta, 3e-3 * zeta + 1e-12);
  }
}

TEST(ContactModes, take_few_evaluations_and_solve_the_equation_of_the_receptance) {
  const DampedTrain train = damped_line(1e9);
  const Eigen::MatrixXcd M = train.train.mass(), K = train.train.stiffness(), B = train.train.contacts();
  for (const TrainMode& mode : train.modes) {
    int evaluations = 0;
    const auto counted = [&](std::complex<double> s, double tolerance) {
      ++evaluations;
      return stand_in(s, tolerance);
    };
    const std::complex<double> s = contact_mode(train, mode, counted);
    EXPECT_LE(evaluations, mode.mesh_share > 1e-10 ? 6 : 0);
    if (evaluations == 0) continue;
    const Eigen::MatrixXcd without = s * s * M + K;
    const std::complex<double> G = (B * solved_complex(without, B.transpose().col(0))).value();
    EXPECT_LT(std::abs(1.0 + stand_in(s, 0.0) * G), 1e-6);
  }
}

// What small damping is to first order, and two gears that only turn, whose equation is one of second degree.
TEST(ContactModes, of_springs_and_dampers_are_those_of_the_damped_train) {
  const double k = stiffness_of("weber_bores"), mass = case_study().at("m_ge");
  const auto spring = [k](std::complex<double>, double) { return std::complex<double>(k); };
  Train pair({gear_node(0, false), gear_node(1, false)});
  mesh_gears(pair);
  const DampedTrain damped = damped_train(pair, {.stiffness = k, .damping = 2.0 * 0.3 * std::sqrt(k * mass)}, 0.0);
  const std::complex<double> s = contact_mode(damped, damped.modes[0], spring);
  EXPECT_NEAR(ratio_of(s), 0.3, 1e-8);
  EXPECT_NEAR(std::abs(s) / damped.modes[0].rate, 1.0, 1e-8);
  const DampedTrain line = damped_train(line_with_motor_and_load(false), {.stiffness = k}, 0.01);
  for (const TrainMode& mode : line.modes) {
    EXPECT_NEAR(ratio_of(contact_mode(line, mode, spring)), line.damping_ratio(mode), 1e-9);
  }
}

TEST(ContactModes, that_do_not_oscillate_are_not_found) {
  Train pair({gear_node(0, false), gear_node(1, false)});
  mesh_gears(pair);
  const DampedTrain damped = damped_train(pair, {.stiffness = 2e8, .damping = 1e6}, 0.0);
  const auto spring = [](std::complex<double>, double) { return std::complex<double>(2e8); };
  EXPECT_THROW(contact_mode(damped, damped.modes[0], spring), SolveError);
}

}  // namespace
}  // namespace gearfilm::trains
