// The mode in which a gear pair swings on its films at rest, from the films' dynamic stiffness.
//
// A displacement H_k exp(s T) of a film at rest changes its pressure by p exp(s T) with
//   (A + s B) p = -(a + s b) H_k ,      A = dG/dP ,  a = dG/dH ,  B, b: the same of rho H at full nodes
// and its force by -K_k(s) H_k: K_k(s) = Int (A + s B)^-1 (a + s b). On rigid teeth H_k = H_0; on teeth that give way
// (compliance.hpp) the forces are those of (I + K C) F = -K H_0 together. The pair swings at the s with
//   I_n s^2 + sum_k [(I + K(s) C)^-1 K(s)]_k = 0 ,
// found by the secant method from s = i 2 pi f_n on, or from a guess, its first slope that of the inertia alone, 2 I_n
// s: K changes little while s changes by the damping. Solutions go on from those at the last two s, and are no tighter
// than the next step needs; the last ones are as tight as asked for. H_0 is part of this mode by construction: a mode
// of the films alone is no solution.
#pragma once

#include <complex>
#include <memory>
#include <optional>

#include "dynamics/lubricated_pair.hpp"

namespace gearfilm {

struct SwingOptions {
  double tolerance = 1e-9;          ///< on the change of s, relative
  int max_iterations = 40;          ///< of the secant method
  double krylov_tolerance = 1e-11;  ///< relative, of the last solutions for p
  int krylov_max_iterations = 600;
  std::optional<std::complex<double>> guess{};  ///< of s, such as that on a coarser grid
  Watcher watcher{};                            ///< called every Krylov iteration
};

struct SwingingMode {
  std::complex<double> rate;       ///< s [1/t*], with Im s > 0
  int solutions = 0;               ///< of linear systems, all films
  int krylov_iterations = 0;       ///< in all of them
  double swings_in_passage = 0.0;  ///< |s|/U, the largest of the films: radians while oil passes a
};

/// -dF/dH_0 of all contacts together of a pair in a state at rest, placed; the options must outlive it.
class DynamicStiffness {
public:
  DynamicStiffness(LubricatedPair& pair, Vec state, const SwingOptions& options);
  ~DynamicStiffness();

  /// K at s, from linear solutions of a relative tolerance. Throws SolveError where one does not converge. Collective.
  std::complex<double> at(std::complex<double> s, double krylov_tolerance);

  int solutions() const;          ///< of linear systems, all films
  int krylov_iterations() const;  ///< in all of them

private:
  class Memory;
  class Films;
  std::unique_ptr<Films> films_;
};

/// The mode of a pair in a state at rest. Throws SolveError where a linear solution or the secant method does not
/// converge, or the pair does not swing. Collective.
SwingingMode swinging_mode(LubricatedPair& pair, Vec state, const SwingOptions& options = {});

}  // namespace gearfilm
