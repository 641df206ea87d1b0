// The errors that are expected of a film on a grid, and the steps with which they stay within an accuracy.
//
// Laws of r_x = h_x/l and r_y = h_y/l, l = H^(2/3) the length over which pressure rises in the inlet (grid/domain.hpp);
// h_x in units of the half-axis a, h_y of b; H = h_c R_x/a^2 by the film formula, L of Moes, kappa = a/b. Fitted to 42
// computed contacts, M = 20 to 3e5, L = 4 to 27, D = 5e-4 to 1 (docs/data/converged_contacts.csv); tried
// up to l = 5.5 (docs/notes/2026-11-thick-oil-in-motion.md).
// Fitted discretisation; bounds, since errors change their sign with the step:
//   central film   0.12 r_x^4 + 0.25 h_x^2/max(1, l)^2 + 0.12 kappa^(1/2) h_y^2
//   smallest film  0.012 L^0.9/(1 + 0.66 kappa) r_x^2 + 0.4 kappa^4/(kappa^4 + 0.16^4) r_y^2
// Between rough surfaces, whose asperities carry where the film would be thin, less depends on the sides (a circular
// contact at L_a = 0.4 and 0.8, 17 to 129 rows):
//   central film   0.12 r_x^4 + 0.25 h_x^2/max(1, l)^2 + 0.5 kappa^(1/2) h_y^2
//   smallest film  0.012 L^0.9/(1 + 0.66 kappa) r_x^2 + kappa^(1/2) h_y^2
// relative to the mean gap, and rows never so far apart that a film tears.
// Central discretisation:
//   central film   0.395 L^0.416 r_x^2 + 0.33 kappa r_y^2
//   smallest film  0.15 L^0.955/(1 + 0.66 kappa) r_x^2 + 1.3 kappa r_y^2
// as long as rows are not so far apart that the film tears at its sides,
//   h_y < c min(0.27 H^(3/4) kappa^(-1/4), 0.57 H kappa^(-1/2), 1.1 H^0.885 kappa^(-0.49) L^(-0.61)),
// c = 1.2, fitted 3.
#pragma once

#include "film/reynolds.hpp"
#include "grid/domain.hpp"

namespace gearfilm {

/// Steps of a grid, in units of a along X and of b along Y.
struct Steps {
  double x = 0.0;
  double y = 0.0;
};

/// Relative errors that are expected of a film on such steps.
struct FilmErrors {
  double central = 0.0;
  double smallest = 0.0;  ///< infinite where the film tears
};
FilmErrors expected_errors(FilmDiscretisation discretisation, const ExpectedFilm& expected, const Steps& steps);

/// The longest step along Y [b]: two thirds of that from which on a film tears at its sides.
double longest_side_step(FilmDiscretisation discretisation, const ExpectedFilm& expected);

/// Relative, what errors of fitted films that change their sign with the step may be though two grids agree.
inline constexpr FilmErrors least_bars{.central = 0.0035, .smallest = 0.0125};

/// Of both errors, where a case does not say it (grid.accuracy).
inline constexpr double usual_accuracy = 0.02;

/// The longest steps on which neither error exceeds `accuracy`.
Steps steps_for(FilmDiscretisation discretisation, const ExpectedFilm& expected, double accuracy);

}  // namespace gearfilm
