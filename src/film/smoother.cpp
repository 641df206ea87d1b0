#include "film/smoother.hpp"

#include "film/line_smoother.hpp"
#include "film/row_smoother.hpp"

namespace gearfilm {

template <class Real>
void Smoother<Real>::find_coupled(const FilmState& state, double elastic_coefficient) {
  constexpr double negligible = 1e-4;
  for (int i = 0; i < coupled_.nx(); ++i) {
    const double* full_film = state.full_film.row(i);  // 0 or 1
    Part* coupled = coupled_.row(i);
    for (int j = 0; j < coupled_.y_count(); ++j) coupled[j] = static_cast<Part>(full_film[j]);
    if (!state.rough || i == 0 || i == coupled_.nx() - 1) continue;
    const double* slope = state.rough->asperity_slope.row(i);
    for (int j = 0; j < coupled_.y_count(); ++j) {
      if (-slope[j] * elastic_coefficient > negligible) coupled[j] = Part(1);
    }
  }
}

template <class Real>
std::unique_ptr<Smoother<Real>> make_smoother(const Grid& grid, const Halo& halo,
                                              const Deformation<PartOf<Real>>& deformation) {
  if (grid.row_axis().has_equal_steps()) return std::make_unique<LineSmoother<Real>>(grid, halo, deformation);
  return std::make_unique<RowSmoother<Real>>(grid, halo, deformation);
}

template class Smoother<float>;
template class Smoother<double>;
template class Smoother<std::complex<double>>;
template std::unique_ptr<Smoother<float>> make_smoother(const Grid&, const Halo&, const Deformation<float>&);
template std::unique_ptr<Smoother<double>> make_smoother(const Grid&, const Halo&, const Deformation<double>&);
template std::unique_ptr<Smoother<std::complex<double>>> make_smoother(const Grid&, const Halo&,
                                                                       const Deformation<double>&);

}  // namespace gearfilm
