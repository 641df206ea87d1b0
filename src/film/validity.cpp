#include "film/validity.hpp"

#include <cmath>
#include <sstream>

#include "contact/line_contact.hpp"
#include "film/face_pressure.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {

void check_domain(const Grid& grid, const Scales& scales, const ContactConditions& conditions, double pressure_integral,
                  const std::string& where) {
  if (pressure_integral <= 0.0) return;
  const GridShape& shape = grid.shape();
  if (!has_ellipse(scales.solids)) {
    const double half_width = largest_half_width(scales, conditions, pressure_integral);
    if (half_width < std::min(shape.x_max, -shape.x_min)) return;
    std::ostringstream message;
    message << where << ": the dry contact under " << pressure_integral / scales.static_force
            << " times the static load is " << half_width << " a wide on either side, and the grid reaches from "
            << shape.x_min << " to " << shape.x_max << "; set grid_x_min and grid_x_max beyond it";
    throw SolveError(message.str());
  }
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
  require(ellipse.b / scales.hertz.b, scales.hertz.ellipticity * shape.row_axis.half_width(), "side", "grid_y_half");
  require(ellipse.a / scales.hertz.a + conditions.nearest.X, shape.x_max, "outlet", "grid_x_max");
  require(ellipse.a / scales.hertz.a - conditions.nearest.X, shape.x_min, "inlet", "grid_x_min");
}

void check_validity(const ContactFilm& film, const FilmQuantities& quantities, const std::string& where) {
  if (!quantities.finite) {
    throw SolveError(where + ": the film is not finite; use a finer grid (grid_nx, grid_ny)");
  }
  // Rough surfaces carry each other where their mean planes overlap.
  if (quantities.smallest_film <= 0.0 && !film.scales().solids.rough) {
    std::ostringstream message;
    if (film.scales().solids.face && film.scales().solids.face->end != EndFace::free) {
      message << where << ": smallest film " << quantities.smallest_film * film.scales().thickness
              << " m is not positive: the flanks touch at the end of the face, beneath which the solids go on; give an "
                 "end relief, or end_face: free";
      throw SolveError(message.str());
    }
    message << where << ": smallest film " << quantities.smallest_film * film.scales().thickness
            << " m is not positive; use a finer grid (grid_nx, grid_ny) or a wider domain (grid_x_min, grid_x_max, "
               "grid_y_half)";
    throw SolveError(message.str());
  }
  check_domain(film.grid(), film.scales(), film.conditions(), quantities.pressure_integral, where);
}

}  // namespace gearfilm
