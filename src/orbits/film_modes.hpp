// Natural modes of the lubricated pair with its geometry held: the films and the motion linearised about rest.
//
//   A y + lambda B y = 0 ,   y = (dP_k, dH_0, dV_0) ~ exp(lambda T)
// with A the linearised stationary system of film_system.hpp and B the squeeze term and the inertia. SLEPc finds the
// eigenvalues nearest zero by shift and invert; A^-1 is our own Krylov solver with its multigrid. Most are films by
// themselves, real or strongly damped; for the swinging pair see dynamic_stiffness.hpp.
#pragma once

#include <complex>
#include <vector>

#include "dynamics/lubricated_pair.hpp"

namespace gearfilm {

struct FilmModeOptions {
  int count = 4;                    ///< eigenvalues to compute
  double tolerance = 1e-8;          ///< relative, of an eigenvalue
  double krylov_tolerance = 1e-11;  ///< relative, of each solution with A
  int krylov_max_iterations = 400;
  Watcher watcher{};  ///< called every Krylov iteration
};

struct FilmMode {
  std::complex<double> eigenvalue;  ///< lambda [1/t*]
  double error = 0.0;               ///< SLEPc's relative estimate
};

/// Modes about a state at rest at the pair's present place, those nearest zero first. Throws SolveError where they do
/// not converge.
std::vector<FilmMode> film_modes(LubricatedPair& pair, Vec state, const FilmModeOptions& options);

}  // namespace gearfilm
