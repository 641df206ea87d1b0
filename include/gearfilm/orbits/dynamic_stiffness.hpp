// The mode in which a gear pair swings on its films at rest, from the films' dynamic stiffness.
//
// A displacement H_k exp(s T) of a film at rest changes its pressure by p exp(s T) with
//   (A + s B) p = -(a + s b) H_k ,      A = dG/dP ,  a = dG/dH ,  B, b: the same of rho H at wet nodes
// and its force by -K_k(s) H_k: K_k(s) = Int (A + s B)^-1 (a + s b). On rigid teeth H_k = H_0; on teeth that give way
// (compliance.hpp) the forces are those of (I + K C) F = -K H_0 together. The pair swings at the s with
//   I_n s^2 + sum_k [(I + K(s) C)^-1 K(s)]_k = 0 ,
// found by the secant method from s = i 2 pi f_n on. H_0 is part of this mode by construction: a mode of the films
// alone is no solution.
#pragma once

#include <complex>

#include "gearfilm/dynamics/lubricated_pair.hpp"

namespace gearfilm {

struct SwingOptions {
  double tolerance = 1e-9;          ///< on the change of s, relative
  int max_iterations = 30;          ///< of the secant method
  double krylov_tolerance = 1e-11;  ///< relative, of each solution for p
  int krylov_max_iterations = 600;
  Watcher watcher{};  ///< told every Krylov iteration
};

/// -dF/dH_0 of all contacts together of a pair in a state at rest, at the pair's present place. Throws SolveError where
/// the linear solution does not converge. Collective.
std::complex<double> dynamic_stiffness(LubricatedPair& pair, Vec state, std::complex<double> s,
                                       const SwingOptions& options = {});

/// s of the swinging pair [1/t*], with Im s > 0. Throws SolveError where the secant method does not converge, or the
/// pair does not swing.
std::complex<double> swinging_mode(LubricatedPair& pair, Vec state, const SwingOptions& options = {});

}  // namespace gearfilm
