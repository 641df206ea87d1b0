#include "orbits/multiplier_error.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

// Multipliers of pairs whose films err by more do not.
const Tuned<double> telling_film_error("multiplier_telling_film_error", 0.04,
                                       "largest error of films that counts for multipliers");
const Tuned<double> damping_by_grid("multiplier_damping_by_grid", 0.3,
                                    "relative error of damping on a grid whose films err by so much");
const Tuned<double> growth_by_grid("multiplier_growth_by_grid", 0.2, "error of a real multiplier's logarithm there");

}  // namespace

FilmErrors film_errors(const OrbitProblem& problem) {
  return expected_errors(problem.numerics.discretisation, ExpectedFilm(problem.mesh.scales),
                         steps_of(problem.numerics));
}

double multiplier_grid_error(const OrbitProblem& problem, const Multipliers& multipliers) {
  const FilmErrors films = film_errors(problem);
  const double ratio = std::min(std::max(films.central, films.smallest) / telling_film_error, 1.0);
  const double modulus = largest_modulus(multipliers);
  const bool real = largest_multiplier(multipliers).imag() == 0.0;
  const double of_logarithm = real ? +growth_by_grid : damping_by_grid * std::abs(std::log(modulus));
  return modulus * of_logarithm * ratio * ratio;
}

}  // namespace gearfilm
