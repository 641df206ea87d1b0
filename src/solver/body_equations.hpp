// The equations of the bodies on which films press: m scalars s under the forces F of n contacts, which they displace.
//
//   M ds/dT + K s + r = C F ,      displacement of contact k:  H_0k = (B s)_k
// M and K are m x m, r has m entries, C is m x n and B n x m. There is one set of equations for each way in which
// contacts can be held; what holds the films is all that distinguishes a stationary film from a gear pair. Rows are
// relative errors, so that they can be weighed against each other. Where reverse flanks touch, they add the force F_b
// of their approach:
//
//   M ds/dT + K s + r + c F_b(b . s) = C F
#pragma once

#include <Eigen/Core>
#include <functional>

namespace gearfilm {

struct BodyEquations {
  Eigen::MatrixXd mass;          ///< M
  Eigen::MatrixXd stiffness;     ///< K
  Eigen::VectorXd constant;      ///< r
  Eigen::MatrixXd force;         ///< C
  Eigen::MatrixXd displacement;  ///< B

  Eigen::Index size() const { return constant.size(); }
  /// Left less right side of the equations.
  Eigen::VectorXd rows(const Eigen::VectorXd& scalars, const Eigen::VectorXd& rates,
                       const Eigen::VectorXd& forces) const;
  /// By how much the rows change with scalars, rates and forces.
  Eigen::VectorXd rows_of_change(const Eigen::VectorXd& scalars, const Eigen::VectorXd& rates,
                                 const Eigen::VectorXd& forces) const;
  /// Derivative of the rows by the scalars, m x m, where rates change by shift times the scalars and forces fall by
  /// film_stiffness (n x m) times the scalars.
  Eigen::MatrixXd jacobian(double shift, const Eigen::MatrixXd& film_stiffness) const;
};

/// Rates of the scalars by a difference formula of their own, where ds/dT is what that of the films makes of them:
/// factor ds/dT + constant.
struct OwnRates {
  double factor = 1.0;
  Eigen::VectorXd constant{};  ///< m entries, or none for zero
};

BodyEquations with_rates(BodyEquations bodies, const OwnRates& rates);

/// H_0 - value = 0 for all films.
BodyEquations fixed_approach(double H0, std::size_t films);

/// (F - sum_k F_k)/F = 0, with H_0 free.
BodyEquations load_balance(double force, std::size_t films);

/// The inertia I_n of a pair, its static force F*, the share f of F* that the films carry in the place of all contacts,
/// and a force A that presses the gears together besides.
struct PairLoad {
  double inertia = 0.0;
  double static_force = 1.0;
  double share = 1.0;
  double pressing = 0.0;
};

/// dH_0/dT - V_0 = 0 ,  (I_n dV_0/dT - sum_k F_k/f + F* + A)/F* = 0: (25) of doi 10.1016/j.triboint.2013.01.017 for
/// s = (H_0, V_0). Without inertia, I_n = 0, the last row is the quasi-static balance.
BodyEquations equation_of_motion(const PairLoad& load, std::size_t films);

/// The force of reverse flanks, F_b(b . s), and where it enters the body equations.
struct ReverseFlankForce {
  struct Value {
    double force = 0.0;  ///< F_b
    double slope = 0.0;  ///< its derivative by the approach
  };
  std::function<Value(double approach)> law{};  ///< empty where there are no reverse flanks
  Eigen::RowVectorXd approach{};                ///< b, m entries
  Eigen::VectorXd column{};                     ///< c, m entries

  /// c F_b; zero without reverse flanks.
  Eigen::VectorXd rows(const Eigen::VectorXd& scalars) const;
  /// The derivative of the rows by the scalars, m x m.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& scalars) const;
};

}  // namespace gearfilm
