// Films, the compliance beneath them (compliance.hpp) and the bodies on which they press (body_equations.hpp) as one
// nonlinear system.
//
//   G_k(P_k, H_k; d(rho H)_k/dT) = 0        every contact k: Reynolds' equation with cavitation, contact_film.hpp
//   M ds/dT + K s + r + c F_b(b . s) = C F ,       F_k = Int Int P_k ,  H_k = (B s)_k + sum_j c_kj F_j
//
// State: [P_1, ..., P_n, s], the scalars on the first process. The squeeze term differentiates rho H, not P: a time
// scheme is given C(state) = [(rho H)_1, ..., (rho H)_n, s] to difference, so mass is conserved. The body equations are
// weighed so that norm/weight() is a root mean square over the films plus relative errors of the bodies.
// Preconditioner: one multigrid cycle a contact, and the scalars before it, as if no force changed with them (in time
// steps on rigid solids: a contact's stiffness is 1e-4 of I_n/dT^2), or scalars and displacements eliminated exactly:
// with the forces Z_k of (dG_k/dP_k)^-1 r_k and S_k of (dG_k/dP_k)^-1 dG_k/dH_k
//
//   (shift M + K + C (I + S C_c)^-1 S B + c F_b' b) s = r_s + C (I + S C_c)^-1 Z ,      C_c = (c_kj)
// Coarse levels may diverge where the smoother does not, on single rows of long cells: a flexible Krylov method that
// has not got on with the cycle has cycle and smoother by turns.
#pragma once

#include <functional>
#include <vector>

#include "algebra/dense.hpp"
#include "elasticity/compliance.hpp"
#include "film/contact_film.hpp"
#include "grid/integral.hpp"
#include "grid/worst_node.hpp"
#include "numerics/newton.hpp"
#include "solver/body_equations.hpp"

namespace gearfilm {

class FilmSystem final : public LinearisedSystem {
public:
  /// At least one film, none twice, all of one discretisation, and the bodies on which as many films press; the films
  /// must outlive the system.
  FilmSystem(std::vector<ContactFilm*> films, BodyEquations bodies);

  std::size_t films() const { return films_.size(); }
  ContactFilm& film(std::size_t contact) { return *films_[contact]; }
  /// Other bodies with as many scalars, what the films stand on, and the force of reverse flanks.
  void set_bodies(BodyEquations bodies, Compliance compliance = {}, ReverseFlankForce reverse_flanks = {});
  const Compliance& compliance() const { return compliance_; }

  OwnedVec create_state() const;
  /// The compact field of one contact (its pressure, or d(rho H)/dT in a rate) into or out of a state; out of it as a
  /// copy. Likewise the scalars, which are common to all processes.
  void set_field(Vec state, std::size_t contact, std::span<const double> field) const;
  std::vector<double> field(Vec state, std::size_t contact) const;
  void set_scalars(Vec state, std::span<const double> scalars) const;
  std::vector<double> scalars(Vec state) const;
  /// Where oil flows freely and pressure falls, makes a guess by its square root, with the weights of the last states,
  /// latest first: near an edge of the full film pressure grows as the square of the distance from it. Dry nodes stay
  /// dry.
  void extrapolate_falls(Vec guess, std::span<const double> weights,
                         const std::function<Vec(std::size_t)>& state) const;
  /// Makes every pressure of a guess at least half of what it is in the last state, where that is not small, and >= 0.
  void clip_predictor(Vec guess, Vec last) const;

  /// d C(state)/dT, null where nothing moves, and about what it grows by with C, which scales the rows of cavitated
  /// nodes.
  struct Rate {
    Vec values = nullptr;
    double shift = 0.0;
  };

  // Collective, all of them.
  void residual(Vec state, const Rate& rate, Vec rows);
  /// C(state).
  void transient(Vec state, Vec values);
  enum class BlockElimination { scalars_first, exact };
  /// Makes the Jacobian at a state, for d(rate)/d(C) = shift and the calls below. On solids that give way the
  /// elimination is always exact.
  void linearise(Vec state, const Rate& rate, double shift, BlockElimination elimination,
                 SmootherFactors factors = SmootherFactors::of_this_state);
  PressureLimits pressure_limits() const override { return limits_; }
  double merit(Vec rows) override;
  void project_change(Vec state, Vec change) override;
  bool relax_overshot_nodes(Vec change, Vec whole, Vec before, Vec after) override;
  double moved() override;
  void copied(Vec from, Vec to) override { versions_.copied(from, to); }
  bool in_single_precision() const override;
  void multiply(Vec change, Vec rows) override;
  /// The part of multiply() that grows with the shift.
  void multiply_transient(Vec change, Vec rows);
  void precondition(Vec rows, Vec change) override;
  /// H_k, or their changes.
  Eigen::VectorXd displacements(Vec state) const;
  /// Quantities of the films of all contacts.
  std::vector<FilmQuantities> quantities(Vec state);
  /// Where the rows of one contact are largest.
  WorstNode worst_node(Vec rows, std::size_t contact) const;

  /// sqrt(nodes of all films).
  double weight() const { return weight_; }
  MPI_Comm comm() const override { return grid_.comm(); }
  const Grid& grid() const { return grid_; }
  PetscInt local_size() const override;
  PetscInt pressure_count() const override { return static_cast<PetscInt>(scalars_at()); }

private:
  std::size_t field_size() const { return static_cast<std::size_t>(grid_.local_size()); }
  /// First scalar in a local array.
  std::size_t scalars_at() const { return films_.size() * field_size(); }
  bool has_scalars() const { return grid_.rank() == 0; }
  template <class Value>
  std::span<Value> part(std::span<Value> values, std::size_t contact) const {
    return values.subspan(contact * field_size(), field_size());
  }
  Squeeze squeeze(std::span<const double> rates, std::size_t contact, double shift) const;
  /// The scalars of a local array, on all processes.
  Eigen::VectorXd scalars_in(std::span<const double> values) const;
  /// Puts scalars into a local array, on the process that has them.
  void put_scalars(const Eigen::VectorXd& scalars, std::span<double> values) const;
  /// F_k of the pressures, or their changes.
  Eigen::VectorXd forces(std::span<const double> values) const;
  /// H_k of the scalars in a state or a change; reads the forces only where solids give way.
  Eigen::VectorXd displacements(std::span<const double> values, const Eigen::VectorXd& scalars) const;
  /// All films at their pressures and displacements.
  void evaluate(std::span<const double> values, const Eigen::VectorXd& displaced, StateVersion version);
  /// change = approximately (dG_k/dP_k)^-1 rows.
  void solve_film(std::size_t contact, std::span<const double> rows, std::span<double> change);
  void precondition_exactly(std::span<const double> rows, std::span<double> change);
  void precondition_scalars_first(std::span<const double> rows, std::span<double> change);

  std::vector<ContactFilm*> films_;
  BodyEquations bodies_;
  Compliance compliance_;
  ReverseFlankForce reverse_flanks_;
  Eigen::MatrixXd reverse_jacobian_;  ///< of their rows, at the state of the Jacobian
  const Grid& grid_;
  double weight_;
  PressureLimits limits_;
  double shift_ = 0.0;
  BlockElimination elimination_ = BlockElimination::scalars_first;
  StateVersions versions_;    ///< of states
  int preconditionings_ = 0;  ///< with the present Jacobian
  LuFactors body_factors_;
  // Of exact elimination, all approximately.
  std::vector<double> responses_;      ///< (dG_k/dP_k)^-1 dG_k/dH_k of all contacts
  LuFactors coupling_factors_;         ///< of I + S C, S_k = Int Int of the response
  Eigen::MatrixXd coupled_stiffness_;  ///< -dF/ds, n x m, the compliance included
  std::vector<double> work_;
};

}  // namespace gearfilm
