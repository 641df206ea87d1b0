// Fluctuations of the torque of a drive train (case_train.hpp).
#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>

#include "input/case_train.hpp"

namespace gearfilm {
namespace {

const std::string harmonics_key = "motor.torque_harmonics";
constexpr long finest_order = 64;       // denominator of an order
constexpr double largest_swing = 0.01;  // of the whole train, over the base pitch

struct WrittenHarmonic {
  double order = 0.0, amplitude = 0.0, degrees = 0.0;
};

std::vector<WrittenHarmonic> written_harmonics(const ParameterValues& values) {
  std::vector<WrittenHarmonic> found;
  std::istringstream parts(values.text(harmonics_key));
  for (std::string part; std::getline(parts, part, ',');) {
    std::istringstream words(part);
    WrittenHarmonic one;
    std::string more;
    const bool numbers = words >> one.order >> one.amplitude >> one.degrees && !(words >> more);
    if (!numbers || !(one.order > 0.0) || !std::isfinite(one.amplitude) || !(std::abs(one.degrees) <= 360.0)) {
      values.refuse(harmonics_key, "has the part '" + part +
                                       "', which is no order > 0, amplitude and phase in degrees; separate parts by "
                                       "commas, as in 1 0.1 0, 6 0.02 30");
    }
    found.push_back(one);
  }
  return found;
}

/// Mesh periods after which an order of a shaft with so many teeth repeats.
long periods_of(const ParameterValues& values, double order, long teeth) {
  for (long denominator = 1; denominator <= finest_order; ++denominator) {
    const double cycles = order * static_cast<double>(denominator);
    if (std::abs(cycles - std::round(cycles)) > 1e-9 * cycles) continue;
    return denominator * teeth / std::gcd(std::lround(cycles), denominator * teeth);
  }
  values.refuse(harmonics_key, "has the order " + format_value(order) +
                                   ", which never repeats together with the mesh; give a whole number or a fraction of "
                                   "at most " +
                                   std::to_string(finest_order) + "ths");
}

/// Where the whole turns freely its speed swings by the torque; contacts are where the mean speed brings them.
void check_swing(const ParameterValues& values, const LineOfAction& line, const TrainCase& given,
                 const WrittenHarmonic& one) {
  const Eigen::VectorXd rigid = relative_motion(given.train).rigid;
  if (rigid.size() == 0) return;
  const double omega = one.order * values.real("pinion.speed_rpm") * 2.0 * std::numbers::pi / 60.0;
  const double turn = given.ripple.node.dot(rigid) * given.ripple.mean * one.amplitude /
                      (rigid.dot(given.train.mass() * rigid) * omega * omega);
  const double way = std::abs(turn * given.train.rotation(0).dot(rigid)) * line.base_radius_pinion();
  if (way <= largest_swing * line.base_pitch()) return;
  values.refuse(harmonics_key, "swings the whole train by " + format_value(way) + " m at the order " +
                                   format_value(one.order) + ", more than " + format_value(largest_swing) +
                                   " of the base pitch: contacts would not be where they are computed; lower its "
                                   "amplitude, or give the inertias of motor and load");
}

}  // namespace

void read_torque_harmonics(const ParameterValues& values, const LineOfAction& line, TrainCase& train) {
  if (!values.has(harmonics_key)) return;
  const std::size_t driven = train.train.find("motor").value_or(0);
  if (train.train.node(driven).fixed) {
    values.refuse(harmonics_key, "is given, but the motor turns at an imposed speed; delete one");
  }
  const int teeth = values.integer("pinion.teeth");
  train.ripple = {.node = train.train.rotation(driven), .mean = values.real("pinion.torque")};
  for (const WrittenHarmonic& one : written_harmonics(values)) {
    check_swing(values, line, train, one);
    train.pattern = std::lcm(train.pattern, periods_of(values, one.order, teeth));
    train.ripple.harmonics.push_back({one.order / teeth, one.amplitude, one.degrees * std::numbers::pi / 180.0});
  }
}

}  // namespace gearfilm
