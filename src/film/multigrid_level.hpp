// One level of the film preconditioner: operator, smoother, and transfer from the next finer level.
#pragma once

#include <span>

#include "film/discretisation.hpp"
#include "film/projected_change.hpp"
#include "film/smoother.hpp"
#include "film/transfer.hpp"

namespace gearfilm {

template <class Real>
class MultigridLevel {
public:
  /// The discretisation must outlive the level.
  explicit MultigridLevel(Discretisation& discretisation);
  MultigridLevel(const MultigridLevel&) = delete;
  MultigridLevel& operator=(const MultigridLevel&) = delete;

  const Discretisation& discretisation() const { return discretisation_; }
  const Grid& grid() const { return discretisation_.grid(); }

  /// Linearises about a state with ghosts and full-film mask, and factors the smoother.
  void update(const FilmState& state, double shift, SmootherFactors factors = SmootherFactors::of_this_state);

  /// rows = linearised film * change; compact.
  void multiply(std::span<const double> change, std::span<double> rows) {
    const Product product{this, change, rows};
    multiply_together({&product, 1});
  }
  /// Products with linearised films on one discretisation, whose deformations are computed together.
  struct Product {
    MultigridLevel* film;
    std::span<const double> change;
    std::span<double> rows;
  };
  static void multiply_together(std::span<const Product> products);
  /// Rows for a change of 1 of the film everywhere; compact.
  void displacement_column(std::span<double> column);
  /// Improves `change` by a number of relaxations; a zero guess saves the first residual.
  void smooth(std::span<const double> right_side, std::span<double> change, int sweeps, bool zero_guess);
  /// change = one relaxation from zero with the displacement column as the residual, both compact, if the smoother
  /// knows it from its factors (smoother.hpp); returns whether it does.
  bool relax_displacement(std::span<const double> column, std::span<double> change);
  /// As project_change() of projected_change.hpp.
  void project_change(std::span<const double> pressure, std::span<const float> weights, std::span<double> change) {
    gearfilm::project_change(grid(), linear_, pressure, weights, change_, change);
  }
  /// Restriction of a fine residual to this level, and addition of this level's correction to the fine one; compact.
  void restrict_from(MultigridLevel& fine, std::span<const double> fine_residual, std::span<double> residual);
  void interpolate_to(MultigridLevel& fine, std::span<const double> correction, std::span<double> fine_change);

private:
  /// rows_ = linearised film * change_
  void apply_operator();
  /// rows_ = linearised film * change_, where deformed_ is the deformation by change_.
  void apply_stencil_to_deformed();

  const Discretisation& discretisation_;
  const Deformation<Real>& deformation_;
  FilmStencil<Real> linear_;
  std::unique_ptr<Smoother<Real>> smoother_;
  Field<Real> change_;
  Field<Real> deformed_;
  Field<Real> rows_;
};

extern template class MultigridLevel<float>;
extern template class MultigridLevel<double>;

}  // namespace gearfilm
