// The rectangle on which the film of one contact is computed: where its edges are at first (room.hpp: how they follow).
#pragma once

#include <cmath>

namespace gearfilm {

/// X from x_min to x_max in units of the Hertz half-axis a, |y| up to y_half in units of the half-axis b.
struct Domain {
  double x_min = 0.0;
  double x_max = 0.0;
  double y_half = 0.0;
};

/// The paper's choice by the load group M: long for M < 200, short from there on.
/// Source: Table 1 of doi 10.1016/j.triboint.2013.01.017.
constexpr Domain paper_domain(double M) { return M < 200.0 ? Domain{-4.5, 1.5, 3.0} : Domain{-2.083, 1.25, 1.1}; }

/// Between the Hertz ellipse and the inlet edge [a], with which a contact is flooded: a longer inlet changes the central
/// film by less than 0.3 %. film: the central film in units of a^2/R_x. Fitted (docs/verification.md).
inline double flooded_inlet(double film) { return 12.0 * std::pow(film, 0.58); }

/// Half the width [b] with which the sides change the forces of a moving contact by less than 0.03 %: pressure reaches
/// about as far beyond the tips of the ellipse as into the inlet. ellipticity: a/b.
inline double clear_side(double film, double ellipticity) {
  const double inlet = ellipticity * flooded_inlet(film);
  return 1.03 + 1.1 * inlet / (1.0 + 0.35 * inlet);
}

/// The choice by the film that is to be expected: flooded and clear under up to 1.25 times the force too.
inline Domain domain_by_film(double film, double ellipticity) {
  return {-1.2 - flooded_inlet(film), 1.25, 1.08 * clear_side(film, ellipticity)};
}

}  // namespace gearfilm
