// The dry pair in its drive train: energy, and the derivatives of its motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "algebra/dense.hpp"
#include "mesh/train_outputs.hpp"
#include "numerics/sampled_integral.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// The example of a motor, gears on isotropic bearings and a load, whose shafts and bearings do not damp.
CaseInput undamped_reducer(const Settings& settings = {}) {
  return input_case("electric_reducer.yaml", with({{"model", "dry"},
                                                   {"train.damping_ratio", "0"},
                                                   {"pinion.bearing_damping_ratio", "0"},
                                                   {"wheel.bearing_damping_ratio", "0"}},
                                                  settings));
}

/// Kinetic energy and that of shafts and bearings, by the modes of M^-1 K: M^-1 e_1 has the part (p_i)_1/m_i of each.
class TrainEnergy {
public:
  explicit TrainEnergy(const MeshTrain& train) {
    const EigenPairs eigen = eigen_pairs(-train.by_displacement);
    const Eigen::MatrixXd modes = eigen.vectors.real();
    to_modes_ = inverse(modes);
    rates_ = eigen.values.real();
    masses_ = modes.row(0).transpose().cwiseQuotient(to_modes_ * train.by_force);
  }

  double kinetic(const Motion& motion) const { return 0.5 * masses_.dot((to_modes_ * motion.v).cwiseAbs2()); }
  double stored(const Motion& motion) const {
    return 0.5 * masses_.cwiseProduct(rates_).dot((to_modes_ * motion.q).cwiseAbs2());
  }
  const Eigen::VectorXd& masses() const { return masses_; }

private:
  Eigen::MatrixXd to_modes_;
  Eigen::VectorXd rates_, masses_;
};

/// Of the contacts and the tooth force, from H_0 = 0 on, by Simpson's rule: they are springs that harden.
double potential(const DryContacts& contacts, double static_force, double H0) {
  constexpr int panels = 20000;
  double sum = 0.0;
  for (int n = 0; n <= panels; ++n) {
    const double weight = n == 0 || n == panels ? 1.0 : (n % 2 == 1 ? 4.0 : 2.0);
    sum += weight * (contacts.total_force(H0 * n / panels) - static_force);
  }
  return -sum * H0 / panels / 3.0;
}

TEST(SampledIntegral, is_exact_for_polynomials_at_any_places) {
  for (const int count : {1, 2, 3, 4, 7}) {
    const int degree = std::min(3, count - 1);
    std::vector<double> places, values;
    for (int n = 0; n < count; ++n) places.push_back(1.0 + n + 0.2 * std::sin(3.0 * n));
    for (const double x : places) values.push_back(std::pow(x, degree) - 2.0);
    const double b = places.back(), a = places.front();
    const double exact = (std::pow(b, degree + 1) - std::pow(a, degree + 1)) / (degree + 1) - 2.0 * (b - a);
    EXPECT_NEAR(sampled_integral(places, values), exact, 1e-11 * (1.0 + std::abs(exact))) << count;
  }
}

TEST(DryTrain, keeps_its_energy_where_nothing_damps) {
  const MeshModel mesh = mesh_model(undamped_reducer(), 0.0, MeshGeometry::held);
  ASSERT_EQ(mesh.freedoms(), 5);  // across the line of action gears on such bearings do not move
  const TrainEnergy energy(*mesh.train);
  EXPECT_GT(energy.masses().minCoeff(), 0.0);
  const DryContacts contacts(DryForce(mesh), mesh, mesh.path.contacts_after(0.0), 0.0);
  const auto total = [&](const Motion& motion) {
    return energy.kinetic(motion) + energy.stored(motion) + potential(contacts, mesh.scales.static_force, motion.H0());
  };
  Motion motion = Motion::zero(mesh.freedoms());
  motion.H0() = contacts.balance(mesh.scales.static_force) - 0.3;
  const double before = total(motion);
  double largest = 0.0, drift = 0.0;
  const DryFlow flow = DryFlow::in_time(mesh, 0.0);
  const double end = 5e-3 / mesh.scales.time;
  constexpr int looks = 100;
  for (int n = 0; n < looks; ++n) {
    motion = flow.between(motion, n * end / looks, (n + 1) * end / looks);
    largest = std::max(largest, energy.kinetic(motion));
    drift = std::max(drift, std::abs(total(motion) - before));
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_LT(drift, 1e-8 * largest);
}

/// Velocities q' of all nodes [rad/s, m/s], from the outputs of the train.
Eigen::VectorXd velocities(const Train& train, const TrainOutputs& outputs, const TrainMoment& moment) {
  const Eigen::VectorXd values = outputs.values(moment);
  const auto value = [&](const std::string& name) {
    return values[std::ranges::find(outputs.list(), name, &TrainOutput::name) - outputs.list().begin()];
  };
  Eigen::VectorXd all = Eigen::VectorXd::Zero(train.freedoms());
  for (std::size_t n = 0; n < train.node_count(); ++n) {
    const std::string& name = train.node(n).name;
    all += value("rotation_velocity_" + name) * train.rotation(n).transpose();
    if (!train.node(n).mass) continue;
    const Eigen::Vector2d place(value("x_velocity_" + name), value("y_velocity_" + name));
    all += train.translation(n).transpose() * place;
  }
  return all;
}

// phi_0^T M q': contacts, reverse flanks, shafts, bearings and dampers are within the train and leave it alone. Torques
// that fluctuate change it by phi_0^T of their integral over time.
TEST(DryTrain, momentum_of_its_rotation_follows_the_torques) {
  for (const std::string harmonics : {"", "1 0.1 0, 6 0.05 30"}) {
    Settings settings{{"model", "dry"}, {"gear.backlash", "1e-5"}};
    if (!harmonics.empty()) settings["motor.torque_harmonics"] = harmonics;
    const MeshModel mesh = mesh_after_leaving(input_case("electric_reducer.yaml", settings));
    const WholeTrain& whole = mesh.train->whole;
    const Train& train = whole.damped->train;
    const Eigen::VectorXd rigid = whole.damped->relative.rigid;
    const auto torque = [&](double T) {
      double sum = 0.0;
      for (const NodeTorque& one : whole.torques) {
        for (const TorqueHarmonic& wave : one.harmonics) {
          const double angle = 2.0 * std::numbers::pi * wave.cycles * T / mesh.path.mesh_period() + wave.phase;
          sum += one.node.dot(rigid) * one.mean * wave.amplitude * std::cos(angle);
        }
      }
      return sum;
    };
    const TrainOutputs outputs(mesh);
    const DryFlow flow = DryFlow::in_time(mesh, 0.01);
    Motion motion = DryMarch::balance(mesh, DryForce(mesh), 0.0);
    motion.v.setConstant(0.01);
    motion.V0() = 10.0;  // thrown against the reverse flanks
    constexpr int looks = 40;
    const double dT = mesh.path.mesh_period() / looks;
    double begun = 0.0, impulse = 0.0, largest_impulse = 0.0, parts = 0.0, off = 0.0;
    for (int n = 0; n <= looks; ++n) {
      const double T = n * dT;
      if (n > 0) {
        motion = flow.between(motion, T - dT, T);
        impulse += mesh.scales.time * dT / 6.0 * (torque(T - dT) + 4.0 * torque(T - 0.5 * dT) + torque(T));
      }
      const Eigen::VectorXd v = velocities(train, outputs, {.T = T, .motion = motion});
      const double momentum = rigid.dot(train.mass() * v);
      if (n == 0) begun = momentum;
      parts = std::max(parts, rigid.cwiseAbs().dot((train.mass() * v).cwiseAbs()));
      largest_impulse = std::max(largest_impulse, std::abs(impulse));
      off = std::max(off, std::abs(momentum - begun - impulse));
    }
    report("%.1e of the momenta of nodes, %.1e of which torques change", off / parts, largest_impulse / parts);
    EXPECT_LT(off, 1e-11 * parts);
    if (!harmonics.empty()) {
      EXPECT_GT(largest_impulse, 1e-4 * parts);
    }
  }
}

// In contact, and thrown against the reverse flanks. Where gaps close the map bends within the step of the differences.
TEST(DryTrain, has_the_derivatives_of_its_map) {
  const MeshModel mesh = mesh_after_leaving(
      undamped_reducer({{"gear.backlash", "1e-5"}, {"motor.torque_harmonics", "1 0.1 0, 6 0.05 30"}}));
  ASSERT_EQ(mesh.freedoms(), 7);  // reverse flanks push in another direction
  EXPECT_EQ(mesh.pattern, 27);
  const DryFlow flow(mesh, mesh, 1.0, 0.02);
  for (const double thrown : {0.01, 10.0}) {
    Motion start = DryMarch::balance(mesh, DryForce(mesh), 0.0);
    start.v.setConstant(0.01);
    start.V0() = thrown;
    const DryFlowEnd end = flow(start, 1);
    const Eigen::VectorXd x = to_vector(start);
    for (Eigen::Index n = 0; n < x.size(); n += 3) {
      constexpr double step = 1e-4;
      const Eigen::VectorXd by = step * Eigen::VectorXd::Unit(x.size(), n);
      const Eigen::VectorXd there = to_vector(flow(to_motion(x + by), 1).states[0]);
      const Eigen::VectorXd back = to_vector(flow(to_motion(x - by), 1).states[0]);
      const Eigen::VectorXd slope = end.by_start.col(n);
      EXPECT_LT(((there - back) / (2.0 * step) - slope).norm(), 1e-4 * (1.0 + slope.norm())) << n;
    }
    EXPECT_LT(to_vector(end.by_parameter).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace gearfilm
