// Modes of a drive train whose contact is no mere spring: its force follows the parting of the flanks by a dynamic
// stiffness S(s), F = -S(s) h for h ~ exp(s t), as films do.
//
//   T(s) v = 0 ,     T(s) = s^2 M + s C + K + S(s) B^T B
// in the relative coordinates (relative_motion.hpp). Modes that the contact feels (B v /= 0) are the roots of
//   1 + S(s) G(s) = 0 ,     G(s) = B (s^2 M + s C + K)^-1 B^T
// between which it has poles; so that each is found from its own undamped mode (s_0 = i w, v_0), by nonlinear inverse
// iteration: T x = T' v, s <- s - (v_0^T M v)/(v_0^T M x), v <- x, with S' from the last two s.
#pragma once

#include <complex>
#include <functional>

#include "train/train_damping.hpp"

namespace gearfilm {

/// S(s) [N/m] at s [1/s], to a relative tolerance.
using DynamicContact = std::function<std::complex<double>(std::complex<double> s, double tolerance)>;

struct ContactModeOptions {
  double tolerance = 1e-9;  ///< on the change of s, relative
  int max_iterations = 30;
  double loosest = 1e-4;        ///< tolerance of the first S
  double tightest = 1e-11;      ///< and of the last ones
  double unfelt_share = 1e-10;  ///< of the mesh, up to which a mode does not feel the contact
};

/// s of the mode that is next to an undamped one [1/s], with Im s > 0. Throws SolveError where it is not found, or does
/// not oscillate.
std::complex<double> contact_mode(const DampedTrain& train, const TrainMode& undamped, const DynamicContact& contact,
                                  const ContactModeOptions& options = {});

}  // namespace gearfilm
