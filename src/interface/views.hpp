// What the public classes see of a case and of films.
#pragma once

#include "film/contact_film.hpp"
#include "gearfilm/results.hpp"
#include "input/case.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Throws InputError for a bare contact.
void require_gears(const CaseInput& input);

struct Results::Content {
  Summary summary = Summary::object();
};

struct Film::View {
  const ContactFilm& film;
};

/// A view of a film, which must outlive it.
inline Film film_of(const ContactFilm& film) { return Film(std::make_shared<const Film::View>(Film::View{film})); }

}  // namespace gearfilm
