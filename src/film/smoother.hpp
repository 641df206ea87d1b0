// One relaxation of the linearised film: what its multigrid levels and its oscillations are improved by.
//
// Equal rows are relaxed with bands (line_smoother.hpp), rows at unequal distances with their whole matrices
// (row_smoother.hpp): there nothing is coarsened across, and what a band leaves would stay.
#pragma once

#include <memory>

#include "elasticity/deformation.hpp"
#include "film/film_stencil.hpp"
#include "film/solver_options.hpp"
#include "grid/halo.hpp"

namespace gearfilm {

template <class Real>
class Smoother {
public:
  using Part = PartOf<Real>;

  virtual ~Smoother() = default;
  Smoother(const Smoother&) = delete;
  Smoother& operator=(const Smoother&) = delete;

  /// Makes the factors of all rows of a film that was linearised for this shift, or keeps earlier ones where it may.
  /// coupled() is then 1 where rows depend on other nodes, else 0.
  virtual void factor(const FilmStencil<Real>& linear, const FilmState& state, ShiftOf<Real> shift,
                      SmootherFactors factors) = 0;
  const Field<Part>& coupled() const { return coupled_; }
  /// change += one relaxation of (linearised rows) * change = residual. Uses `residual` as work space.
  virtual void relax(Field<Real>& residual, Field<Real>& change) = 0;
  /// change += one relaxation with the displacement column, dG/dH_0, as the residual, if that is known from the
  /// present factors without a solve; returns whether it is.
  virtual bool relax_displacement(const Field<Real>& /*column*/, Field<Real>& /*change*/) { return false; }

protected:
  explicit Smoother(const Grid& grid) : coupled_(grid) {}

  /// Where Reynolds' equation holds, and at dry nodes whose asperities carry: their rows d (v - P_a' u) feel the
  /// deformation.
  void find_coupled(const FilmState& state, double elastic_coefficient);

  Field<Part> coupled_;
};

/// The one that serves the rows of the grid. Grid, halo and deformation must outlive it.
template <class Real>
std::unique_ptr<Smoother<Real>> make_smoother(const Grid& grid, const Halo& halo,
                                              const Deformation<PartOf<Real>>& deformation);

}  // namespace gearfilm
