// The motion of the bodies that a mesh joins.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <utility>

namespace gearfilm {

/// Displacements q of n degrees of freedom and their velocities v, dimensionless. A gear pair has one: the rigid
/// displacement of the flanks H_0, and V_0.
struct Motion {
  Motion() : Motion(0.0, 0.0) {}
  Motion(double H0, double V0) : q(Eigen::VectorXd::Constant(1, H0)), v(Eigen::VectorXd::Constant(1, V0)) {}
  Motion(Eigen::VectorXd displacements, Eigen::VectorXd velocities)
      : q(std::move(displacements)), v(std::move(velocities)) {}

  /// No displacement and no velocity of n degrees of freedom.
  static Motion zero(Eigen::Index n) { return {Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)}; }

  Eigen::Index freedoms() const { return q.size(); }
  // H_0 and V_0 of a gear pair, whose one degree of freedom is the first.
  double H0() const { return q[0]; }
  double V0() const { return v[0]; }
  double& H0() { return q[0]; }
  double& V0() { return v[0]; }

  Eigen::VectorXd q;
  Eigen::VectorXd v;
};

/// (q, v), and back from a vector of 2 n numbers.
inline Eigen::VectorXd to_vector(const Motion& motion) {
  Eigen::VectorXd x(2 * motion.freedoms());
  x << motion.q, motion.v;
  return x;
}
inline Motion to_motion(const Eigen::VectorXd& x) { return {x.head(x.size() / 2), x.tail(x.size() / 2)}; }

inline Motion motion_from(std::span<const double> x) {
  const Eigen::Map<const Eigen::VectorXd> all(x.data(), static_cast<Eigen::Index>(x.size()));
  return {all.head(all.size() / 2), all.tail(all.size() / 2)};
}

/// A motion and a multiple of a step.
inline Motion moved(const Motion& from, double by, const Motion& step) {
  return {from.q + by * step.q, from.v + by * step.v};
}
/// A motion of the same displacements, its velocities multiplied by a factor.
inline Motion weighted(const Motion& motion, double velocity_weight) { return {motion.q, velocity_weight * motion.v}; }
inline Motion difference(const Motion& a, const Motion& b) { return {a.q - b.q, a.v - b.v}; }
/// The largest part of either.
inline double length(const Motion& motion) {
  return std::max(motion.q.lpNorm<Eigen::Infinity>(), motion.v.lpNorm<Eigen::Infinity>());
}

}  // namespace gearfilm
