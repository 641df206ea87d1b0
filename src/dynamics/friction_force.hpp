// Friction in the motion of the pair.
//
// The arms of friction are the radii of curvature. With F_1 = -F_s - F_r on the pinion, F_2 = F_s - F_r on the wheel
// and g_i = m_ge R_bi^2/I_i, g_1 + g_2 = 1,
//   I_n dV_0/dT = Int Int P - F* - A/(p_h a^2),
//   A = sum_k [ g_1 (R_1x/R_b1) F_1k - g_2 (R_2x/R_b2) F_2k ]
// at a constant mean speed; what the losses take from the wheel's mean torque, g_2 P/(Omega_1 R_b1), about 0.1 % of the
// force, is left out. In a drive train (mesh_train.hpp) A = -G^T f/(p_h a^2) with
// f = sum_k (R_1x F_1, F_1, R_2x F_2, F_2): torques on the gears, and forces along the flanks. A is taken from the
// films of the last two steps, extrapolated: of second order, and nothing new in the Jacobian.
#pragma once

#include <Eigen/Core>
#include <utility>

#include "dynamics/step_record.hpp"

namespace gearfilm {

/// A/(p_h a^2) of the contacts of a step, for each degree of freedom [-].
Eigen::VectorXd friction_on_motion(const MeshModel& mesh, const std::vector<ContactRecord>& contacts);

/// A in the time step to come.
class ExtrapolatedFriction {
public:
  /// The first one: it stays until there are two.
  void begin(double T, const Eigen::VectorXd& value) { *this = {T, value, Eigen::VectorXd::Zero(value.size())}; }
  void add(double T, const Eigen::VectorXd& value) { *this = {T, value, (value - value_) / (T - T_)}; }
  Eigen::VectorXd at(double T) const { return value_ + slope_ * (T - T_); }

  /// None in so many degrees of freedom.
  explicit ExtrapolatedFriction(Eigen::Index freedoms) { begin(0.0, Eigen::VectorXd::Zero(freedoms)); }

private:
  ExtrapolatedFriction(double T, Eigen::VectorXd value, Eigen::VectorXd slope)
      : T_(T), value_(std::move(value)), slope_(std::move(slope)) {}

  double T_ = 0.0;
  Eigen::VectorXd value_, slope_;
};

}  // namespace gearfilm
