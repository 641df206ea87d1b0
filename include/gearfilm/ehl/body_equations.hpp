// The few scalars beside the films, which see their forces and give them their displacement: a linear system
//
//   M ds/dT + K s + r = C sum_k Int Int P_k dX dY ,      H_0 = d . s     common to every contact k
// One kind for each way in which a contact can be held; what holds the films is all that distinguishes a stationary
// film from a gear pair. Rows are relative errors, so that they can be weighed against each other.
#pragma once

#include <span>
#include <vector>

namespace gearfilm {

/// m scalars; matrices m x m, row by row.
struct BodyEquations {
  std::vector<double> mass;          ///< M
  std::vector<double> stiffness;     ///< K
  std::vector<double> force;         ///< C
  std::vector<double> constant;      ///< r
  std::vector<double> displacement;  ///< d

  std::size_t size() const { return constant.size(); }
  /// H_0 of scalars, or its change.
  double displaced(std::span<const double> scalars) const;
  /// The rows, left less right side; without the constant where changes are given.
  enum class Of { states, changes };
  std::vector<double> rows(std::span<const double> scalars, std::span<const double> rates, double force_sum,
                           Of of) const;
};

/// Row by row, of the scalars of which the rows of changes are known, with rates = shift scalars and a sum of forces
/// that falls by film_stiffness times the displacement: shift M + K + film_stiffness C d^T.
std::vector<double> body_matrix(const BodyEquations& bodies, double shift, double film_stiffness);

/// H_0 - value = 0.
BodyEquations fixed_approach(double H0);

/// (F - Int Int P)/F = 0, with H_0 free.
BodyEquations load_balance(double force);

/// dH_0/dT - V_0 = 0 ,  (I_n dV_0/dT - Int Int P/f + F* + A)/F* = 0: (25) of doi 10.1016/j.triboint.2013.01.017 for
/// s = (H_0, V_0), with a force A that presses the gears together besides. With a share f of the static force F* in the
/// place of other contacts Int Int P counts 1/f times; without inertia, I_n = 0, the last row is the quasi-static
/// balance.
BodyEquations equation_of_motion(double inertia, double static_force, double share, double pressing = 0.0);

}  // namespace gearfilm
