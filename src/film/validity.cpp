#include "film/validity.hpp"

#include <cmath>
#include <sstream>

#include "gearfilm/error.hpp"

namespace gearfilm {

void check_domain(const Grid& grid, const Scales& scales, const ContactConditions& conditions, double pressure_integral,
                  const std::string& where) {
  if (pressure_integral <= 0.0) return;
  const HertzContact ellipse = dry_contact(scales, conditions, pressure_integral);
  const auto require = [&](double half_axis, double edge, const std::string& side, const std::string& option) {
    if (half_axis < std::abs(edge)) return;
    std::ostringstream message;
    message << where << ": the Hertz ellipse under " << pressure_integral / scales.static_force
            << " times the static load (" << half_axis << " of the static half-axis) reaches the " << side
            << " edge of the grid at " << edge << "; set " << option << " beyond "
            << std::copysign(1.1 * half_axis, edge);
    throw SolveError(message.str());
  };
  const GridShape& shape = grid.shape();
  require(ellipse.b / scales.hertz.b, scales.hertz.ellipticity * shape.row_axis.half_width(), "side", "grid_y_half");
  require(ellipse.a / scales.hertz.a + conditions.nearest.X, shape.x_max, "outlet", "grid_x_max");
  require(ellipse.a / scales.hertz.a - conditions.nearest.X, shape.x_min, "inlet", "grid_x_min");
}

void check_validity(const ContactFilm& film, const FilmQuantities& quantities, const std::string& where) {
  if (!quantities.finite) {
    throw SolveError(where + ": the film is not finite; use a finer grid (grid_nx, grid_ny)");
  }
  if (quantities.smallest_film <= 0.0) {
    std::ostringstream message;
    message << where << ": smallest film " << quantities.smallest_film * film.scales().thickness
            << " m is not positive; use a finer grid (grid_nx, grid_ny) or a wider domain (grid_x_min, grid_x_max, "
               "grid_y_half)";
    throw SolveError(message.str());
  }
  check_domain(film.grid(), film.scales(), film.conditions(), quantities.pressure_integral, where);
}

}  // namespace gearfilm
