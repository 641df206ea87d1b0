// The rectangle on which the film of one contact is computed (where its edges are at first; domain_margins.hpp: how
// they follow), from the film that is to be expected.
//
// With H = h_c R_x/a^2 of the film formula, L of Moes and kappa = a/b the law was fitted to 42 computed contacts, M =
// 20 to 3e5, L = 4 to 27, D = 5e-4 to 1 (docs/data/converged_contacts.csv, scripts/studies/film_laws):
//   what a contact lacks of its central film if the inlet is x long, in units of a, beyond the Hertz ellipse
//     0.328 L^0.285 H^1.15 / (x^2 (1 + 0.707 kappa x))
#pragma once

#include "contact/scales.hpp"

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

/// The film to be expected in the reference contact, by the formula of Nijenbanning, Venner and Moes, of a line contact
/// by that of Moes. Rough surfaces that come nearer to each other leave a gap of 0.3 sigma to the flow.
struct ExpectedFilm {
  explicit ExpectedFilm(const Scales& scales);

  double film = 0.0;         ///< H
  double lubricant = 0.0;    ///< L
  double ellipticity = 0.0;  ///< kappa
  bool rough = false;        ///< between rough surfaces that carry where the film is thin
  double reach = 0.0;        ///< of their asperities
};

/// How far beyond the dry contact rough surfaces still press on each other, in units of its half-axis: to where the gap
/// has grown by 4 sigma, beyond a line contact by 2/3 sqrt(2) (X - 1)^(3/2) a^2/R_x. Zero between smooth surfaces.
double asperity_reach(const Scales& scales);

/// H^(2/3), the length over which pressure rises in the inlet, in units of a.
double inlet_rise(const ExpectedFilm& expected);
/// The length over which pressure changes, in units of a: the dry contact's half-axis or, in thick oil, the rise.
double pressure_length(const ExpectedFilm& expected);

/// Distance between the Hertz ellipse and the inlet edge [a] with which 0.3 % of the central film are lacking.
double flooded_inlet(const ExpectedFilm& expected);

/// Half the width [b] that the sides of a film need: pressure reaches about as far beyond the tips of the ellipse as
/// into the inlet. Forces of pairs need more (load_beyond_edges.hpp).
double clear_side(const ExpectedFilm& expected);

/// Flooded and clear, under up to 1.25 times the force too, and with an outlet behind the film's rupture in thick oil.
Domain domain_of(const ExpectedFilm& expected);

/// The most nodes along either direction of a grid that is chosen by a law.
constexpr int most_nodes = 2049;
/// Nodes along a length in steps of at most so much: one more than a multiple of 16, and at least 65, so that there
/// are coarser grids.
int nodes_along(double length, double step);
/// Nodes across the entrainment on a length in steps of at most so much: one more than a multiple of 8, and at least
/// 17, since slender contacts need few.
int nodes_across(double length, double step);

}  // namespace gearfilm
