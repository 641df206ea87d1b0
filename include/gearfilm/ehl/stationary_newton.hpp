// Newton's method for the stationary film of one contact, on one grid.
//
//   G(P, H_0) = 0 ,   F - Int Int P dX dY = 0   or   H_0 given               (film_system.hpp)
// solved together by SNES: exact matrix-free Jacobian, backtracking, FGMRES. A pseudo-time step adds the squeeze term.
#pragma once

#include <optional>
#include <vector>

#include "gearfilm/ehl/film_system.hpp"

namespace gearfilm {

/// Work done by nonlinear solves.
struct SolveCounts {
  int newton = 0;
  int krylov = 0;
  long convolutions = 0;  ///< double-precision ones on the grid itself
  double residual = 0.0;  ///< last root mean square
};

/// What is prescribed: the force a film carries (as its pressure integral), or its rigid displacement H_0.
struct LoadCondition {
  enum class Kind { force, displacement };
  Kind kind = Kind::force;
  double value = 0.0;

  static LoadCondition force(double pressure_integral) { return {Kind::force, pressure_integral}; }
  static LoadCondition displacement(double H0) { return {Kind::displacement, H0}; }
};

/// A film: compact pressure, and its rigid displacement.
struct FilmSolution {
  std::vector<double> pressure;
  double H0 = 0.0;
};

/// An implicit step of (pseudo-)time: d(rho H)/dT = shift (rho H - mass).
struct ImplicitStep {
  double shift = 0.0;
  std::span<const double> mass;  ///< rho H before it, compact
};

class StationaryNewton {
public:
  StationaryNewton(ContactFilm& film, const NewtonOptions& options);
  StationaryNewton(const StationaryNewton&) = delete;
  StationaryNewton& operator=(const StationaryNewton&) = delete;

  /// Solves from `guess` in place: the stationary film, or the film after one step. False if Newton did not reach its
  /// tolerance; then `guess` holds the last iterate.
  bool solve(const LoadCondition& load, FilmSolution& guess, const std::optional<ImplicitStep>& step = {});

  const SolveCounts& counts() const { return counts_; }
  /// Where the last solve() left the largest residual. Collective.
  WorstNode worst() const { return system_.worst_node(residual_, 0); }

private:
  /// d(rho H)/dT at a state, none where there is no step.
  FilmSystem::Rate rate_at(Vec state);
  void evaluate(Vec state, Vec residual);
  void update_jacobian(Vec state);

  ContactFilm& film_;
  FilmSystem system_;
  FilmSystem::Elimination elimination_ = FilmSystem::Elimination::exact;
  std::optional<ImplicitStep> step_;
  OwnedVec state_, residual_, rate_;
  OwnedMat jacobian_;
  OwnedSNES snes_;
  SolveCounts counts_;
};

}  // namespace gearfilm
