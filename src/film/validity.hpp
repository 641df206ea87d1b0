// Whether a computed film may be believed.
//
// A film is outside its model when it is not finite, when H <= 0 somewhere, or when the Hertz ellipse of the force
// it carries reaches the side or outlet edge of its grid (the inlet always carries a little pressure; the ellipse
// must not reach it either). Films computed beyond that look plausible and are wrong by factors.
#pragma once

#include <string>

#include "film/contact_film.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {

/// Throws SolveError, naming `where` (contact and position) and the bound to change, if the Hertz ellipse under a
/// pressure integral reaches an edge of the grid.
void check_domain(const Grid& grid, const Scales& scales, const ContactConditions& conditions, double pressure_integral,
                  const std::string& where);

/// Throws SolveError naming `where`, what is wrong and the remedy, if the film must not be believed.
void check_validity(const ContactFilm& film, const FilmQuantities& quantities, const std::string& where);

/// Runs `solve`; an error of it that says what failed gets `where` in front.
template <class Solve>
auto located(const std::string& where, Solve solve) {
  try {
    return solve();
  } catch (const SolveError& error) {
    throw SolveError(where + ": " + error.what());
  }
}

}  // namespace gearfilm
