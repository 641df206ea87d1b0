// One level of the film preconditioner: operator, smoother, and transfer from the next finer level.
#pragma once

#include <memory>
#include <optional>

#include "gearfilm/ehl/line_smoother.hpp"
#include "gearfilm/ehl/transfer.hpp"

namespace gearfilm {

template <class Real>
class MultigridLevel {
public:
  MultigridLevel(Grid grid, double C_h);
  MultigridLevel(const MultigridLevel&) = delete;
  MultigridLevel& operator=(const MultigridLevel&) = delete;

  const Grid& grid() const { return grid_; }
  FilmState& state() { return state_; }

  /// Linearises about state() and factors the smoother. Exchanges the state's ghosts.
  void update(double entrainment, double storage_shift);

  /// rows = linearised film * change; compact.
  void multiply(const double* change, double* rows);
  /// Improves `change` by a number of relaxations; a zero guess saves the first residual.
  void smooth(const double* right_side, double* change, int sweeps, bool zero_guess);
  /// Restriction of a fine residual to this level, and addition of this level's correction to the fine one; compact.
  void restrict_from(MultigridLevel& fine, const double* fine_residual, double* residual);
  void interpolate_to(MultigridLevel& fine, const double* correction, double* fine_change);

private:
  /// rows_ = linearised film * change_
  void apply_operator();

  Grid grid_;
  Halo halo_;
  Deformation<Real> deformation_;
  LinearFilm<Real> linear_;
  LineSmoother<Real> smoother_;
  FilmState state_;
  Field<Real> change_;
  Field<Real> deformed_;
  Field<Real> rows_;
};

extern template class MultigridLevel<float>;
extern template class MultigridLevel<double>;

}  // namespace gearfilm
