// The linearised map of the motion (q, v) over one mesh period, and what its eigenvalues say.
//
// Multipliers mu = |mu| exp(+-i theta) of a pair with one degree of freedom: a free oscillation whose angle per mesh
// period is known up to whole turns and sign, so its frequency is f_m (n + theta/2 pi) or f_m (n - theta/2 pi); the one
// nearest the linear natural frequency is taken. |mu| < 1 is damping: ratio zeta of the decay over that oscillation.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "mesh/motion.hpp"

namespace gearfilm {

/// d(q, v)(T + mesh period)/d(q, v)(T); 2 n x 2 n, or empty where it is not known.
using Monodromy = Eigen::MatrixXd;

struct FreeOscillation {
  double frequency = 0.0;      ///< [Hz]
  double damping_ratio = 0.0;  ///< zeta [-]
};

using Multipliers = std::vector<std::complex<double>>;

/// The 2 n eigenvalues: of two, that with the larger real part or positive imaginary part first; of more, by falling
/// modulus, of a complex pair the one with positive imaginary part first.
Multipliers multipliers(const Monodromy& monodromy);

/// The one with the largest modulus, the first of several: what a disturbance keeps over one mesh period.
std::complex<double> largest_multiplier(const Multipliers& multipliers);
inline double largest_modulus(const Multipliers& multipliers) { return std::abs(largest_multiplier(multipliers)); }

/// The oscillation by two multipliers, mesh frequency f_m and natural frequency f_n [Hz]. Real multipliers do not
/// oscillate.
std::optional<FreeOscillation> free_oscillation(const Multipliers& multipliers, double mesh_frequency,
                                                double natural_frequency);

}  // namespace gearfilm
