// Newton's method for the stationary film of one contact, on one grid.
//
//   G(P, H_0) = 0 ,   F - Int Int P dX dY = 0   or   H_0 given               (contact_film.hpp)
// solved together as one bordered system by SNES: exact matrix-free Jacobian, backtracking, FGMRES, and as
// preconditioner the film's own, with H_0 eliminated through one preconditioned column. A pseudo-time step adds the
// squeeze term.
#pragma once

#include <vector>

#include "gearfilm/ehl/contact_film.hpp"
#include "gearfilm/ehl/integral.hpp"
#include "gearfilm/ehl/newton.hpp"
#include "gearfilm/ehl/worst_node.hpp"

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

/// Newton's method for the bordered system on one grid.
class StationaryNewton final : public LinearisedSystem {
public:
  StationaryNewton(ContactFilm& film, const NewtonOptions& options);

  /// Solves from `guess` in place. With storage: one pseudo-time step, d(rho H)/dT = shift (rho H - storage).
  /// False if Newton did not reach its tolerance; then `guess` holds the last iterate.
  bool solve(const LoadCondition& load, FilmSolution& guess, double shift = 0.0, const double* storage = nullptr);

  const SolveCounts& counts() const { return counts_; }
  /// Where the last solve() left the largest residual. Collective.
  WorstNode worst() const { return worst_node(grid_, VecReading(residual_)); }

  MPI_Comm comm() const override { return grid_.comm(); }
  PetscInt local_size() const override { return size_ + (has_scalar_ ? 1 : 0); }
  PetscInt pressure_count() const override { return size_; }
  void multiply(Vec change, Vec rows) override;
  void precondition(Vec residual, Vec change) override;

private:
  void evaluate(Vec state, Vec residual);
  void update_jacobian();
  bool fixed() const { return load_.kind == LoadCondition::Kind::displacement; }
  /// The row of the load condition and its linear part: both in units of H_0 or of the force, weighted.
  double load_row(double H0, double carried) const;
  double load_row_change(double change_H0, double change_carried) const;
  double broadcast(double value) const;
  double carried_by(const double* pressure) const { return integral(grid_, pressure, size_); }

  ContactFilm& film_;
  const Grid& grid_;
  int size_;            ///< own nodes
  bool has_scalar_;     ///< the first process also holds H_0
  double load_weight_;  ///< sqrt(nodes)
  LoadCondition load_;
  double shift_ = 0.0;
  const double* storage_ = nullptr;
  std::vector<double> storage_rate_;
  std::vector<double> column_solution_;  ///< (dG/dP)^-1 dG/dH_0, approximately
  double schur_ = 0.0;                   ///< d(load row)/dH_0 after elimination
  OwnedVec state_, residual_;
  OwnedMat jacobian_;
  OwnedSNES snes_;
  SolveCounts counts_;
};

}  // namespace gearfilm
