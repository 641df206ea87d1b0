// Newton's method for stationary films under one condition, on one grid: one film, or those of a gear pair at rest.
//
//   G_k(P_k, H_k) = 0 ,   F - sum_k Int Int P_k dX dY = 0   or   H_0 given               (film_system.hpp)
// solved together by SNES: exact matrix-free Jacobian, backtracking, FGMRES. A pseudo-time step adds the squeeze term.
#pragma once

#include <optional>
#include <vector>

#include "solver/film_system.hpp"

namespace gearfilm {

/// Work done by nonlinear solves.
struct SolveCounts {
  int newton = 0;
  int krylov = 0;
  long convolutions = 0;  ///< double-precision ones on the grid itself
  double residual = 0.0;  ///< last root mean square
};

/// What is prescribed: the force that the films carry (as their pressure integral), or the rigid displacement H_0 of
/// what they stand on.
struct LoadCondition {
  enum class Kind { force, displacement };
  Kind kind = Kind::force;
  double value = 0.0;
  Compliance compliance{};

  static LoadCondition force(double pressure_integral, Compliance compliance = {}) {
    return {Kind::force, pressure_integral, std::move(compliance)};
  }
  static LoadCondition displacement(double H0, Compliance compliance = {}) {
    return {Kind::displacement, H0, std::move(compliance)};
  }
};

/// Films: compact pressures, one film after the other, and their rigid displacement.
struct FilmSolution {
  std::vector<double> pressure;
  double H0 = 0.0;
};

/// An implicit step of (pseudo-)time: d(rho H)/dT = shift (rho H - mass).
struct ImplicitStep {
  double shift = 0.0;
  std::span<const double> mass;  ///< rho H before it, as pressures are kept
};

class StationaryNewton {
public:
  /// The films, of one discretisation, must outlive it.
  StationaryNewton(const std::vector<ContactFilm*>& films, const NewtonOptions& options);
  StationaryNewton(const StationaryNewton&) = delete;
  StationaryNewton& operator=(const StationaryNewton&) = delete;

  /// Solves from `guess` in place: the stationary films, or the films after one step. False if Newton did not reach
  /// its tolerance; then `guess` holds the last iterate.
  bool solve(const LoadCondition& load, FilmSolution& guess, const std::optional<ImplicitStep>& step = {});
  /// Makes films the ones from which step() goes on, under a load.
  void begin(const LoadCondition& load, const FilmSolution& films);
  /// One implicit step of pseudo-time on, with d(rho H)/dT = shift times the change of rho H. False if Newton's method
  /// did not reach its tolerance; then begin() has to be called again.
  bool step(double shift);
  /// The films that solve() or step() has left.
  FilmSolution films() const;
  /// Quantities of the films that solve() or step() has left. Collective.
  std::vector<FilmQuantities> quantities() { return system_.quantities(state_); }

  /// For solves from now on: a root mean square of the residual.
  void aim_at(double tolerance) {
    tolerance_ = tolerance;
    gearfilm::aim_at(snes_, tolerance * system_.weight());
  }
  double tolerance() const { return tolerance_; }
  /// For solves from now on; limited as in time steps.
  void limit_changes(Changes changes);

  const SolveCounts& counts() const { return counts_; }
  /// Where the last solve() left the largest residual, of one film. Collective.
  WorstNode worst(std::size_t film) const { return system_.worst_node(residual_, film); }

private:
  /// Iterates from the present state.
  bool iterate();
  std::vector<double> mass_of_state();
  long convolutions();
  /// d(rho H)/dT at a state, none where there is no step.
  FilmSystem::Rate rate_at(Vec state);
  void evaluate(Vec state, Vec residual);
  void update_jacobian(Vec state);
  /// Makes SNES call the watcher in every iteration.
  void watch();
  void tell(PetscInt krylov);

  FilmSystem system_;
  FilmSystem::BlockElimination elimination_ = FilmSystem::BlockElimination::exact;
  std::optional<ImplicitStep> step_;
  std::vector<double> mass_;  ///< before a step of step()
  OwnedVec state_, residual_, rate_;
  OwnedMat jacobian_;
  OwnedSNES snes_;
  double tolerance_;
  int max_iterations_;
  Changes changes_ = Changes::free;
  SolveCounts counts_;
  Watcher watcher_;
  struct {
    PetscInt newton;
    double residual;  ///< root mean square
  } watched_{};       ///< the last Newton iteration
};

}  // namespace gearfilm
