#include "film/multigrid_level.hpp"

#include <vector>

#include "parallel/events.hpp"

namespace gearfilm {

template <class Real>
MultigridLevel<Real>::MultigridLevel(Discretisation& discretisation)
    : discretisation_(discretisation),
      deformation_(discretisation.prepare_deformation<Real>()),
      linear_(grid()),
      smoother_(make_smoother<Real>(grid(), discretisation.halo(), deformation_)),
      change_(grid()),
      deformed_(grid()),
      rows_(grid()) {}

template <class Real>
void MultigridLevel<Real>::update(const FilmState& state, double shift, SmootherFactors factors) {
  linearise(discretisation_.equation(), shift, state, linear_);
  smoother_->factor(linear_, state, shift, factors);
}

template <class Real>
void MultigridLevel<Real>::apply_operator() {
  deformation_.apply(change_, deformed_);
  apply_stencil_to_deformed();
}

template <class Real>
void MultigridLevel<Real>::apply_stencil_to_deformed() {
  discretisation_.halo().exchange(change_, deformed_);
  apply_stencil(linear_, change_, deformed_, rows_);
}

template <class Real>
void MultigridLevel<Real>::multiply_together(std::span<const Product> products) {
  std::vector<const Field<Real>*> changes;
  std::vector<Field<Real>*> deformed;
  for (const Product& product : products) {
    product.film->change_.load(product.change);
    changes.push_back(&product.film->change_);
    deformed.push_back(&product.film->deformed_);
  }
  products.front().film->deformation_.apply(changes, deformed);
  for (const Product& product : products) {
    product.film->apply_stencil_to_deformed();
    product.film->rows_.store(product.rows);
  }
}

template <class Real>
void MultigridLevel<Real>::displacement_column(std::span<double> column) {
  gearfilm::displacement_column(linear_, rows_);
  rows_.store(column);
}

template <class Real>
void MultigridLevel<Real>::smooth(std::span<const double> right_side, std::span<double> change, int sweeps,
                                  bool zero_guess) {
  if (zero_guess) {
    change_.fill(Real(0));
  } else {
    change_.load(change);
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (sweep == 0 && zero_guess) {
      rows_.load(right_side);
    } else {
      apply_operator();
      for (int i = 0; i < grid().nx(); ++i) {
        Real* rows = rows_.row(i);
        const double* right = right_side.data() + static_cast<std::size_t>(i) * grid().y_count();
        for (int j = 0; j < grid().y_count(); ++j) rows[j] = static_cast<Real>(right[j]) - rows[j];
      }
    }
    smoother_->relax(rows_, change_);
  }
  change_.store(change);
}

template <class Real>
bool MultigridLevel<Real>::relax_displacement(std::span<const double> column, std::span<double> change) {
  rows_.load(column);
  change_.fill(Real(0));
  if (!smoother_->relax_displacement(rows_, change_)) return false;
  change_.store(change);
  return true;
}

template <class Real>
void MultigridLevel<Real>::restrict_from(MultigridLevel& fine, std::span<const double> fine_residual,
                                         std::span<double> residual) {
  const ScopedEvent event(Kernel::transfer);
  fine.rows_.load(fine_residual);
  fine.discretisation_.halo().exchange(fine.rows_);
  rows_.fill(Real(0));
  restrict_residual(fine.grid(), grid(), fine.rows_, smoother_->coupled(), rows_);
  rows_.store(residual);
}

template <class Real>
void MultigridLevel<Real>::interpolate_to(MultigridLevel& fine, std::span<const double> correction,
                                          std::span<double> fine_change) {
  const ScopedEvent event(Kernel::transfer);
  change_.load(correction);
  discretisation_.halo().exchange(change_);
  fine.change_.load(fine_change);
  add_interpolated(grid(), fine.grid(), change_, fine.smoother_->coupled(), fine.change_);
  fine.change_.store(fine_change);
}

template class MultigridLevel<float>;
template class MultigridLevel<double>;

}  // namespace gearfilm
