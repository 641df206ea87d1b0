#include "traction/sheared_flow.hpp"

#include <cmath>

#include "traction/film_line.hpp"

namespace gearfilm {

void put_shear(const ShearLaw& law, double log_newtonian, double half_gradient, double x, std::size_t node,
               FlowFactors& flow) {
  const ShearThinning thinning = shear_thinning(law, log_newtonian, half_gradient);
  flow.shear_power = thinning_power(law);
  flow.shear_index[node] = shear_of(flow.shear_power, thinning.log_along, x);
  flow.cross_flow[node] = std::exp(thinning.log_across - thinning.log_along);
}

FlowFactors sheared_flow(const TractionModel& model, const ContactFilm& film) {
  const Grid& grid = film.grid();
  FlowFactors flow = FlowFactors::none(grid.local_size());
  flow.sheared = true;
  FilmLine line(film);
  const double log_ambient = std::log(film.scales().oil.viscosity);
  for (int i = 0; i < grid.nx(); ++i) {
    line.load(i);
    for (int j = 0; j < grid.y_count(); ++j) {
      const double h = line.thickness[j], log_viscosity = line.log_viscosity[j];
      put_shear(model.law, log_viscosity + std::log(std::abs(line.velocities[j].sliding) / h),
                0.5 * h * line.gradient[j], log_viscosity - log_ambient,
                static_cast<std::size_t>(i) * grid.y_count() + j, flow);
    }
  }
  return flow;
}

}  // namespace gearfilm
