// Dry and lubricated line contacts, w' the load by unit length, and contacts that are loaded along a whole face of the
// width F, w' = w/F.
//
//   a = (8 w' R_x/(pi E'))^(1/2) ,  p_h = 2 w'/(pi a)            (Johnson, Contact Mechanics, 1985, ch. 4)
//   approach of a uniform line load in the middle of the face:  a^2/(2 R_x) (ln(2 F/a) + 1/2)
// Central film of an incompressible fluid in M = w'/(E' R_x) s^(-1/2), L = alpha_B E' s^(1/4), s = 2 eta_0 u_m/(E'
// R_x), with H = (h/R_x) s^(-1/2), divided by rho(p_h)/rho_0 as the formula for points is:
//   H_RI = 3/M ,  H_EI = 2.621 M^(-1/5) ,  H_RP = 1.287 L^(2/3) ,  H_EP = 1.311 M^(-1/8) L^(3/4)
//   q = (7 + 8 e^(-2 H_EI/H_RI))/5
//   H = { (H_RI^(7/3) + H_EI^(7/3))^(3q/7) + (H_RP^(-7/2) + H_EP^(-7/2))^(-2q/7) }^(1/q)
// (Moes' line contact, second-hand: no source was looked up).
#pragma once

#include "contact/moes.hpp"

namespace gearfilm {

/// Half-width a and pressure under the load by unit length; b endless, ellipticity and approach zero.
HertzContact line_contact(const ContactSolids& solids, double load_per_length);

/// Half-width, pressure and approach beneath a load [N] that is spread evenly over the face; b = F/2.
HertzContact finite_line_contact(const ContactSolids& solids, double load);

/// Whether it is neither endless nor loaded along a whole face.
bool has_ellipse(const ContactSolids& solids);

/// Central film [m] of a line contact.
double moes_line_central(const ContactSolids& solids, const Lubricant& oil, double load_per_length,
                         double entrainment_velocity);

/// Load by unit length of an operation, whether of a line contact or of a face [N/m].
double load_per_length(const ContactSolids& solids, const ContactOperation& operation);

/// Central film by the formula of the contact's kind: of a line, a face, or an ellipse.
double expected_central_film(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);

}  // namespace gearfilm
