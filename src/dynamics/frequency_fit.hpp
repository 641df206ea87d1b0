// A swing of the pair as difference formulas see it, and what makes them see it rightly.
//
// A backward difference formula turns d/dT of exp(i w T) into a complex number D instead of i w (slope_weights.hpp). A
// free oscillation dH/dT = V, dV/dT = -w^2 H thereby becomes slower or faster, and damped: BDF2 has D = i w (1 + (w
// dT)^2/3) + w (w dT)^3/4 + ... With x = Im D/w and y = Re D, D is y + x i w, so that
//
//   dH/dT + alpha dV/dT = beta V ,                      alpha = y/(w^2 x), beta = x + y^2/(w^2 x)
//   f dV/dT + c V + w^2 H = 0 ,                         f = 1/x, c = -y/x
// have H = exp(i w T), V = i w H as their solution in the formula, whatever dT is. H is in the restoring force alone:
// where it rests does not matter. Where nothing presses, w = 0, nothing is changed. Bodies with n degrees of freedom
// have as many swings, each with its own fit; these become matrices by their shapes.
#pragma once

#include <complex>
#include <functional>

#include "solver/body_equations.hpp"

namespace gearfilm {

struct FrequencyFit {
  double alpha = 0.0;    ///< [T]
  double beta = 1.0;     ///< [-]
  double inertia = 1.0;  ///< f [-]
  double damping = 0.0;  ///< c [1/T], over the inertia
};

/// For a formula that makes D [1/T] of i w, w [1/T].
FrequencyFit frequency_fit(double w, std::complex<double> D);

/// Undamped free oscillations of the bodies on their contacts: rates w [1/T] and shapes, a column each, by which
/// y = (shapes) z; coordinates: its inverse.
struct Swings {
  Eigen::VectorXd rates;
  Eigen::MatrixXd shapes, coordinates;
  double contact_stiffness = 0.0;  ///< [-]
};

/// The fits of all oscillations together, as matrices in y.
struct ModalFit {
  ModalFit(const Swings& swings, const std::function<FrequencyFit(double w)>& fit_of);

  Eigen::MatrixXd alpha, beta, inertia, damping;
};

/// An equation of motion with s = (y, dy/dT), so fitted.
BodyEquations fitted(BodyEquations motion, const ModalFit& fit);

}  // namespace gearfilm
