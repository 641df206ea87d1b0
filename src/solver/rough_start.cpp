#include "solver/rough_start.hpp"

namespace gearfilm {
namespace {

/// Of the largest pressure, what asperities carry where the search for the dry contact begins.
constexpr double first_share = 0.9;

/// The dry contact, with P = P_a(H).
bool solve_dry(StationaryNewton& newton, ContactFilm& film, const LoadCondition& load, FilmSolution& contact) {
  struct Drained {
    explicit Drained(ContactFilm& of) : film(of) { film.set_without_oil(true); }
    ~Drained() { film.set_without_oil(false); }
    Drained(const Drained&) = delete;
    Drained& operator=(const Drained&) = delete;
    ContactFilm& film;
  };
  const Drained drained(film);
  return newton.solve(load, contact);
}

}  // namespace

bool solve_from_dry_contact(StationaryNewton& newton, ContactFilm& film, const LoadCondition& load,
                            FilmSolution& guess) {
  const RoughSurfaces& rough = *film.scales().solids.rough;
  const double sigma = rough.sigma() / film.scales().thickness;
  const bool given = load.kind == LoadCondition::Kind::displacement;
  FilmSolution dry = guess;
  if (!given) {
    const FilmQuantities smooth = film.quantities(guess.pressure, 0.0);
    const double touching =
        rough.asperities().gap_under(first_share * film.scales().pressure * smooth.largest_pressure);
    dry.H0 = sigma * touching - smooth.central_film - load.compliance(0, 0) * smooth.pressure_integral;
    if (!solve_dry(newton, film, load, dry)) return false;
  }
  for (const double raise : {1.0, 0.5, 2.0, 0.25, 3.0}) {
    FilmSolution film_guess = dry;
    if (given) {
      film_guess.H0 = load.value - raise * sigma;
      if (!solve_dry(newton, film, LoadCondition::displacement(film_guess.H0, load.compliance), film_guess)) continue;
      film_guess.H0 = load.value;
    } else {
      film_guess.H0 += raise * sigma;
    }
    if (newton.solve(load, film_guess)) {
      guess = film_guess;
      return true;
    }
  }
  return false;
}

}  // namespace gearfilm
