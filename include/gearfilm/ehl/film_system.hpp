// Films and the border that holds them (border.hpp) as one nonlinear system.
//
//   G_k(P_k, H_0; d(rho H)_k/dT) = 0        every contact k: Reynolds' equation with cavitation, contact_film.hpp
//   border(s, ds/dT, sum_k Int Int P_k) = 0 ,       H_0 = d . s
//
// State: [P_1, ..., P_n, s], the scalars on the first process. The squeeze term differentiates rho H, not P: a time
// scheme is given C(state) = [(rho H)_1, ..., (rho H)_n, s] to difference, so mass is conserved. The border's rows are
// weighed so that norm/weight() is a root mean square over the films plus relative errors of the border.
// Preconditioner: one multigrid cycle a contact, and the border before it, as if no force changed with it (in time
// steps: a contact's stiffness is 1e-4 of I_n/dT^2), or eliminated exactly.
#pragma once

#include <vector>

#include "gearfilm/ehl/border.hpp"
#include "gearfilm/ehl/contact_film.hpp"
#include "gearfilm/ehl/integral.hpp"
#include "gearfilm/ehl/newton.hpp"
#include "gearfilm/ehl/worst_node.hpp"

namespace gearfilm {

class FilmSystem final : public LinearisedSystem {
public:
  /// At least one film, all of one discretisation; they must outlive the system.
  FilmSystem(std::vector<ContactFilm*> films, Border border);

  std::size_t films() const { return films_.size(); }
  ContactFilm& film(std::size_t contact) { return *films_[contact]; }
  /// Another border with as many scalars.
  void set_border(Border border) { border_ = std::move(border); }

  OwnedVec create_state() const;
  /// The compact field of one contact (its pressure, or d(rho H)/dT in a rate) into or out of a state; out of it as a
  /// copy. Likewise the scalars, which are common to all processes.
  void set_field(Vec state, std::size_t contact, std::span<const double> field) const;
  std::vector<double> field(Vec state, std::size_t contact) const;
  void set_scalars(Vec state, std::span<const double> scalars) const;
  std::vector<double> scalars(Vec state) const;
  /// Makes every pressure of a guess at least half of what it is in the last state, and >= 0.
  void restrain(Vec guess, Vec last) const;

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
  enum class Elimination { border_first, exact };
  /// Makes the Jacobian at a state, for d(rate)/d(C) = shift and the calls below.
  void linearise(Vec state, const Rate& rate, double shift, Elimination elimination);
  double merit(Vec rows) override;
  void multiply(Vec change, Vec rows) override;
  /// The part of multiply() that grows with the shift.
  void multiply_transient(Vec change, Vec rows);
  void precondition(Vec rows, Vec change) override;
  /// Of every contact.
  std::vector<FilmFigures> figures(Vec state);
  /// Where the rows of one contact are largest.
  WorstNode worst_node(Vec rows, std::size_t contact) const;

  /// sqrt(nodes of all films).
  double weight() const { return weight_; }
  MPI_Comm comm() const override { return grid_.comm(); }
  PetscInt local_size() const override;
  PetscInt pressure_count() const override { return static_cast<PetscInt>(border_at()); }

private:
  std::size_t field_size() const { return static_cast<std::size_t>(grid_.local_size()); }
  /// First entry of the border in a local array.
  std::size_t border_at() const { return films_.size() * field_size(); }
  bool has_border() const { return grid_.rank() == 0; }
  template <class Value>
  std::span<Value> part(std::span<Value> values, std::size_t contact) const {
    return values.subspan(contact * field_size(), field_size());
  }
  Squeeze squeeze(std::span<const double> rates, std::size_t contact, double shift) const;
  std::vector<double> scalars_in(std::span<const double> values) const;
  void put_rows(const std::vector<double>& rows, std::span<double> values) const;
  /// Int Int of the pressures, or their changes, of all contacts together.
  double force_sum(std::span<const double> values) const { return integral(grid_, values.first(border_at())); }

  std::vector<ContactFilm*> films_;
  Border border_;
  const Grid& grid_;
  double weight_;
  double shift_ = 0.0;
  Elimination elimination_ = Elimination::border_first;
  std::vector<double> responses_;  ///< (dG_k/dP_k)^-1 dG_k/dH_0 of all contacts, approximately; of exact elimination
  BorderFactors border_factors_;
  std::vector<double> work_;
};

}  // namespace gearfilm
