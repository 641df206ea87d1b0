#include "gearfilm/traction/film_line.hpp"

#include <cmath>

#include "gearfilm/lubricant/independent_iterations.hpp"

namespace gearfilm {

FilmLine::FilmLine(const ContactFilm& film)
    : pressure(film.grid().y_count()),
      thickness(pressure.size()),
      log_viscosity(pressure.size()),
      density(pressure.size()),
      gradient(pressure.size()),
      wet(pressure.size()),
      film_(film),
      laws_(film.scales().oil) {}

template <ViscosityLaw law>
void FilmLine::set_viscosity() {
  const double ambient = std::log(film_.scales().oil.viscosity);
  const double* p = pressure.data();
  double* log_eta = log_viscosity.data();
  const std::size_t count = pressure.size();
  const OilLaws laws = laws_;
  GEARFILM_INDEPENDENT_ITERATIONS
  for (std::size_t j = 0; j < count; ++j) log_eta[j] = ambient + laws.log_viscosity<law>(p[j]).value;
}

void FilmLine::load(int i) {
  const Grid& grid = film_.grid();
  const Scales& scales = film_.scales();
  const Field<double>& P = film_.film_pressure();
  const bool inside = i > 0 && i < grid.nx() - 1;
  const double *here = P.row(i), *west = P.row(inside ? i - 1 : i), *east = P.row(inside ? i + 1 : i);
  const double *H = film_.thickness().row(i), *rho = film_.state().density.row(i);
  const double by_x = scales.pressure / (2.0 * scales.length * grid.h_x());
  for (int j = 0; j < grid.y_count(); ++j) {
    pressure[j] = scales.pressure * here[j];
    thickness[j] = scales.thickness * H[j];
    density[j] = rho[j];
    gradient[j] = by_x * (east[j] - west[j]);
    wet[j] = here[j] > 0.0;
  }
  with_viscosity_law(scales.oil, [&]<ViscosityLaw law>() { set_viscosity<law>(); });
}

}  // namespace gearfilm
