#include "solver/body_equations.hpp"

namespace gearfilm {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd BodyEquations::rows(const VectorXd& scalars, const VectorXd& rates, const VectorXd& forces) const {
  return rows_of_change(scalars, rates, forces) + constant;
}

VectorXd BodyEquations::rows_of_change(const VectorXd& scalars, const VectorXd& rates, const VectorXd& forces) const {
  return mass * rates + stiffness * scalars - force * forces;
}

MatrixXd BodyEquations::jacobian(double shift, const MatrixXd& film_stiffness) const {
  return shift * mass + stiffness + force * film_stiffness;
}

BodyEquations with_rates(BodyEquations bodies, const OwnRates& rates) {
  if (rates.constant.size() > 0) bodies.constant += bodies.mass * rates.constant;
  bodies.mass *= rates.factor;
  return bodies;
}

BodyEquations fixed_approach(double H0, std::size_t films) {
  const auto n = static_cast<Eigen::Index>(films);
  return {.mass = MatrixXd::Zero(1, 1),
          .stiffness = MatrixXd::Ones(1, 1),
          .constant = VectorXd::Constant(1, -H0),
          .force = MatrixXd::Zero(1, n),
          .displacement = MatrixXd::Ones(n, 1)};
}

BodyEquations load_balance(double force, std::size_t films) {
  const auto n = static_cast<Eigen::Index>(films);
  return {.mass = MatrixXd::Zero(1, 1),
          .stiffness = MatrixXd::Zero(1, 1),
          .constant = VectorXd::Ones(1),
          .force = MatrixXd::Constant(1, n, 1.0 / force),
          .displacement = MatrixXd::Ones(n, 1)};
}

BodyEquations equation_of_motion(const PairLoad& load, std::size_t films) {
  const auto n = static_cast<Eigen::Index>(films);
  return {.mass = Eigen::Vector2d(1.0, load.inertia / load.static_force).asDiagonal(),
          .stiffness = MatrixXd{{0.0, -1.0}, {0.0, 0.0}},
          .constant = Eigen::Vector2d(0.0, 1.0 + load.pressing / load.static_force),
          .force = Eigen::Vector2d(0.0, 1.0 / (load.share * load.static_force)).rowwise().replicate(n),
          .displacement = Eigen::RowVector2d(1.0, 0.0).colwise().replicate(n)};
}

VectorXd ReverseFlankForce::rows(const VectorXd& scalars) const {
  if (!law) return VectorXd::Zero(scalars.size());
  return column * law(approach * scalars).force;
}

MatrixXd ReverseFlankForce::jacobian(const VectorXd& scalars) const {
  if (!law) return MatrixXd::Zero(scalars.size(), scalars.size());
  return column * law(approach * scalars).slope * approach;
}

}  // namespace gearfilm
