// The linearised film of one contact on all its levels: its products, and its multigrid preconditioner.
//
// One V-cycle of PETSc's PCMG. Its levels are shells: the operator of every level is the film linearised about the
// state injected from the finest one (film_stencil.hpp) with that level's own convolution, its smoother that
// of smoother.hpp, its transfers those of transfer.hpp. Where cells are long across,
// levels have half the lines and all rows: what the smoother leaves there are long waves along X of single rows. One
// level means the smoother alone. Where a coarser grid would leave a process fewer than two rows, every process goes on
// with the whole rest of the hierarchy itself: the same cycle for any number of processes.
#pragma once

#include <cmath>
#include <memory>
#include <span>

#include "film/discretisation.hpp"
#include "film/film_state.hpp"
#include "film/solver_options.hpp"

namespace gearfilm {

class LinearisedFilm {
public:
  virtual ~LinearisedFilm() = default;

  /// Linearises about a state (with ghosts and full-film mask) of the finest grid.
  virtual void update(const FilmState& state, double shift,
                      SmootherFactors factors = SmootherFactors::of_this_state) = 0;
  /// rows = linearised rows for a change of the pressure; compact.
  void multiply(std::span<const double> change, std::span<double> rows) {
    const Product product{this, change, rows};
    multiply_together({&product, 1});
  }
  struct Product {
    LinearisedFilm* film;
    std::span<const double> change;
    std::span<double> rows;
  };
  /// The products of several films, one of them this one; returns false, and makes none, where they differ in
  /// discretisation or precision.
  virtual bool multiply_together(std::span<const Product> products) = 0;
  /// The linearised rows for a change of 1 of the film everywhere: dG/dH_0; compact.
  virtual void displacement_column(std::span<double> column) = 0;
  /// change = approximate inverse of the linearised rows applied to residual; both compact.
  virtual void apply(std::span<const double> residual, std::span<double> change) = 0;
  /// change = approximate inverse of the linearised rows applied to the displacement column, both compact, if the
  /// smoother knows it from its factors (smoother.hpp); returns whether it does.
  virtual bool relax_displacement(std::span<const double> column, std::span<double> change) = 0;
  /// Approximate solution as above, by one relaxation on the finest level.
  virtual void relax(std::span<const double> residual, std::span<double> change) = 0;
  /// Makes a change that would leave pressures below zero one that leaves them there, of nodes with these weights of
  /// rows (projected_change.hpp); compact.
  virtual void project_change(std::span<const double> pressure, std::span<const float> weights,
                              std::span<double> change) = 0;
  virtual int levels() const = 0;
};

/// Arithmetic and number of levels by the options; where these leave the number open, no level is coarser along X than
/// the longest step. The discretisation must outlive the preconditioner.
std::unique_ptr<LinearisedFilm> make_linearised_film(Discretisation& discretisation, const MultigridOptions& options,
                                                     double longest_step = HUGE_VAL);

}  // namespace gearfilm
