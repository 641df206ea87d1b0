#include "gearfilm/ehl/validity.hpp"

#include <sstream>

#include "gearfilm/error.hpp"

namespace gearfilm {

void check_validity(const ContactFilm& film, const FilmFigures& figures, const std::string& where) {
  std::ostringstream message;
  message << where << ": ";
  if (!figures.finite) {
    message << "the film is not finite; use a finer grid (grid_nx, grid_ny)";
    throw SolveError(message.str());
  }
  const Scales& scales = film.scales();
  if (figures.smallest_film <= 0.0) {
    message << "smallest film " << figures.smallest_film * scales.film
            << " m is not positive; use a finer grid (grid_nx, grid_ny) or a wider domain (grid_x_min, grid_x_max, "
               "grid_y_half)";
    throw SolveError(message.str());
  }
  if (figures.pressure_integral <= 0.0) return;
  const HertzContact ellipse = dry_contact(scales, film.conditions(), figures.pressure_integral);
  const GridShape& shape = film.grid().shape();
  const double a = ellipse.a / scales.length, b = ellipse.b / scales.length;
  const double force_ratio = figures.pressure_integral / scales.static_force;
  const double kappa = scales.hertz.ellipticity;
  const auto require = [&](double half_axis, double edge, const std::string& side, const std::string& option) {
    if (half_axis < edge) return;
    const double margin = option == "grid_x_min" ? -1.1 : 1.1;
    message << "the Hertz ellipse under " << force_ratio << " times the static load (half-axis " << half_axis
            << " of the static one) reaches the " << side << " edge of the grid at " << edge << "; set " << option
            << " beyond " << margin * half_axis;
    throw SolveError(message.str());
  };
  require(kappa * b, kappa * shape.y_half, "side", "grid_y_half");
  require(a, shape.x_max, "outlet", "grid_x_max");
  require(a, -shape.x_min, "inlet", "grid_x_min");
}

}  // namespace gearfilm
