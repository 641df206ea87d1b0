// Kinematics of a spur-gear pair along its line of action.
//
// Position xi [m] on the line of action is zero at the pitch point and grows from the root to the
// tip of the pinion tooth; a tooth contact moves with d(xi)/dt = Omega_1 R_b1.
// Source: Barbieri, Lubrecht, Pellicano 2013, doi 10.1016/j.triboint.2013.01.017, eqs (13)-(19).
#pragma once

#include <array>
#include <vector>

#include "gear/gear_pair.hpp"

namespace gearfilm {

/// Geometry and velocities of the contacts of one gear pair as functions of xi.
class LineOfAction {
public:
  /// Throws InputError when the pair cannot mesh: non-positive dimensions, centre distance not above the sum
  /// of the base radii, tip circles inside base circles, contact ratio below 1, a contact that would reach
  /// below a base circle (R_1x or R_2x <= 0 within the path of contact), or a path without the pitch point.
  explicit LineOfAction(const SpurGearPair& pair);

  double base_radius_pinion() const { return base_radius_pinion_; }          ///< R_b1 [m]
  double base_radius_wheel() const { return base_radius_wheel_; }            ///< R_b2 [m]
  double working_pressure_angle() const { return working_pressure_angle_; }  ///< alpha' [rad]
  double speed_ratio() const { return speed_ratio_; }                        ///< tau = Z_1/Z_2 = Omega_2/Omega_1
  double base_pitch() const { return base_pitch_; }                          ///< p_b [m]
  double entry() const { return entry_; }                                    ///< xi_s < 0, where a contact enters [m]
  double exit() const { return exit_; }                                      ///< xi_e > 0, where it leaves [m]
  double contact_ratio() const { return (exit_ - entry_) / base_pitch_; }    ///< eps

  /// Radii of curvature of the two flanks, and the reduced one in the plane of rotation, R_x [m].
  double radius_pinion(double xi) const;
  double radius_wheel(double xi) const;
  double radius_x(double xi) const;
  /// Lengths of both involutes from their base circles to the contact, rho_i^2/(2 R_bi) [m].
  std::array<double, 2> involute_lengths(double xi) const;
  /// Reduced radius across the face from both crownings, R_y [m]; infinity for uncrowned gears.
  /// The smallest and the largest R_x on the path of contact over that of the pitch point.
  std::array<double, 2> relative_radii() const;
  double radius_y() const { return radius_y_; }

  /// Entrainment u_m = (u_1+u_2)/2 and sliding u_1-u_2 [m/s] at the pinion's angular speed omega_1 [rad/s].
  double entrainment_velocity(double xi, double pinion_speed) const;
  double sliding_velocity(double xi, double pinion_speed) const;
  /// Velocity of the contact along the line of action, d(xi)/dt [m/s].
  double travel_velocity(double pinion_speed) const;

  /// H_v: power lost by sliding over the power transmitted and a friction coefficient that is the same everywhere,
  /// while n contacts share the load equally: (1+tau)/(R_b1 p_b) Int |xi|/n d(xi). For 1 <= eps <= 2 that is
  /// Ohlendorf's pi (u+1)/(Z_1 u) (1 - eps + eps_1^2 + eps_2^2), u = Z_2/Z_1, eps_1 = xi_e/p_b, eps_2 = -xi_s/p_b.
  double loss_factor() const;

  /// Positions of all contacts when one of them is at xi: xi + n p_b within [entry, exit], leading
  /// (largest) first; an end of the path counts despite round-off. Empty only if no such position exists.
  std::vector<double> contact_positions(double xi) const;

private:
  double base_radius_pinion_ = 0.0;
  double base_radius_wheel_ = 0.0;
  double working_pressure_angle_ = 0.0;
  double speed_ratio_ = 0.0;
  double base_pitch_ = 0.0;
  double entry_ = 0.0;
  double exit_ = 0.0;
  double radius_y_ = 0.0;
};

/// Mesh frequency f_m = Omega_1 Z_1/(2 pi) [Hz].
double mesh_frequency(const SpurGearPair& pair, double pinion_speed);

/// Equivalent mass along the line of action, 1/m_ge = R_b1^2/I_g1 + R_b2^2/I_g2 [kg]; inertias in [kg m^2].
double equivalent_mass(const LineOfAction& line, double pinion_inertia, double wheel_inertia);

}  // namespace gearfilm
