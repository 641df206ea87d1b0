#include "traction/film_line.hpp"

#include <algorithm>
#include <cmath>

#include "lubricant/independent_iterations.hpp"

namespace gearfilm {
namespace {

template <EvaluatesViscosity Viscosity>
void set_viscosity(Viscosity viscosity, double ambient, const std::vector<double>& pressure,
                   std::vector<double>& log_viscosity) {
  const double* p = pressure.data();
  double* log_eta = log_viscosity.data();
  const std::size_t count = pressure.size();
  GEARFILM_INDEPENDENT_ITERATIONS
  for (std::size_t j = 0; j < count; ++j) log_eta[j] = ambient + viscosity.log_viscosity(p[j]).value;
}

}  // namespace

std::vector<SurfaceVelocities> row_velocities(const ContactFilm& film) {
  const double u_m = film.scales().operation.entrainment_velocity;
  const ContactSurfaces& surfaces = film.surfaces();
  std::vector<SurfaceVelocities> velocities;
  for (std::size_t j = 0; j < surfaces.entrainment.size(); ++j) {
    velocities.push_back({.mean = u_m * surfaces.entrainment[j], .sliding = u_m * surfaces.sliding[j]});
  }
  return velocities;
}

FilmLine::FilmLine(const ContactFilm& film)
    : pressure(film.grid().y_count()),
      thickness(pressure.size()),
      log_viscosity(pressure.size()),
      density(pressure.size()),
      gradient(pressure.size()),
      poiseuille(pressure.size()),
      full_film(pressure.size()),
      velocities(row_velocities(film)),
      film_(film),
      viscosity_(viscosity_evaluator(film.scales().oil)) {}

void FilmLine::load(int i) {
  const Grid& grid = film_.grid();
  const Scales& scales = film_.scales();
  const Field<double>& P = film_.film_pressure();
  const bool rough = film_.state().rough.has_value(), inside = i > 0 && i < grid.nx() - 1;
  const double *here = P.row(i), *west = P.row(inside ? i - 1 : i), *east = P.row(inside ? i + 1 : i);
  const double *H = film_.mean_gap().row(i), *rho = film_.state().density.row(i);
  // Dry nodes of rough surfaces have what Newton's method leaves.
  const double least = rough ? 1e-6 : 0.0;
  const double by_x = scales.pressure / (2.0 * scales.length * grid.h_x());
  for (int j = 0; j < grid.y_count(); ++j) {
    pressure[j] = scales.pressure * (rough ? std::max(here[j], 0.0) : here[j]);
    thickness[j] = scales.thickness * H[j];
    density[j] = rho[j];
    gradient[j] = by_x * (east[j] - west[j]);
    full_film[j] = here[j] > least;
  }
  const double ambient = std::log(scales.oil.viscosity);
  std::visit([&](auto viscosity) { set_viscosity(viscosity, ambient, pressure, log_viscosity); }, viscosity_);
}

void FilmLine::load_flow(int i) {
  const Scales& scales = film_.scales();
  const double* H = film_.mean_gap().row(i);
  // h^3/(12 eta) = xi_R/rho lambda (a^2/R_x)^3/(12 eta_0)
  const double by_flow = scales.lambda * scales.thickness * scales.thickness * scales.pressure /
                         (12.0 * scales.oil.viscosity * scales.length);
  poiseuille_flow(film_.discretisation()->equation(), film_.state(), i, poiseuille);
  for (std::size_t j = 0; j < poiseuille.size(); ++j) poiseuille[j] *= H[j] > 0.0 ? by_flow / H[j] : 0.0;
}

}  // namespace gearfilm
