// The linearised map of the motion (H_0, V_0) over one mesh period, and what its eigenvalues say.
//
// Multipliers mu = |mu| exp(+-i theta): a free oscillation whose angle per mesh period is known up to whole turns and
// sign, so its frequency is f_m (n + theta/2 pi) or f_m (n - theta/2 pi); the one nearest the linear natural frequency
// is taken. |mu| < 1 is damping: ratio zeta of the decay over that oscillation.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <optional>

#include "gearfilm/mesh/motion.hpp"

namespace gearfilm {

/// d(H_0, V_0)(T + mesh period)/d(H_0, V_0)(T).
using Monodromy = Eigen::Matrix2d;

inline Eigen::Vector2d to_vector(const Motion& motion) { return {motion.H0, motion.V0}; }
inline Motion to_motion(const Eigen::Vector2d& vector) { return {vector[0], vector[1]}; }

struct FreeOscillation {
  double frequency = 0.0;      ///< [Hz]
  double damping_ratio = 0.0;  ///< zeta [-]
};

/// The two eigenvalues; of a complex pair the one with positive imaginary part first.
std::array<std::complex<double>, 2> multipliers(const Monodromy& monodromy);

/// Modulus of the larger one: what a disturbance keeps over one mesh period.
double largest_modulus(const std::array<std::complex<double>, 2>& multipliers);

/// From the multipliers, the mesh frequency f_m and the linear natural frequency f_n [Hz]. Real multipliers do not
/// oscillate.
std::optional<FreeOscillation> free_oscillation(const std::array<std::complex<double>, 2>& multipliers,
                                                double mesh_frequency, double natural_frequency);

}  // namespace gearfilm
