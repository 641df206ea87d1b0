#include "film/smoother.hpp"

#include "film/line_smoother.hpp"
#include "film/row_smoother.hpp"

namespace gearfilm {

template <class Real>
std::unique_ptr<Smoother<Real>> make_smoother(const Grid& grid, const Halo& halo,
                                              const Deformation<PartOf<Real>>& deformation) {
  if (grid.row_axis().has_equal_steps()) return std::make_unique<LineSmoother<Real>>(grid, halo, deformation);
  return std::make_unique<RowSmoother<Real>>(grid, deformation);
}

template std::unique_ptr<Smoother<float>> make_smoother(const Grid&, const Halo&, const Deformation<float>&);
template std::unique_ptr<Smoother<double>> make_smoother(const Grid&, const Halo&, const Deformation<double>&);
template std::unique_ptr<Smoother<std::complex<double>>> make_smoother(const Grid&, const Halo&,
                                                                       const Deformation<double>&);

}  // namespace gearfilm
