// The one place where dimensional and dimensionless quantities meet.
//
// Everything inside the solver is dimensionless, with scales frozen at the reference contact (the pitch point
// of a gear pair, or the bare contact itself):
//   X = x/a, Y = y/a, P = p/p_h, H = h R_x*/a^2, T = t/t*, t* = a/u_m*, U = u_m/u_m*, Rbar = R_x/R_x*
//   lambda = 12 u_m* eta_0 R_x*^2/(a^3 p_h)      C_h = 2 p_h R_x*/(pi E' a)      F* = w*/(p_h a^2)
// with a and p_h of the ellipse, F* = 2 pi/(3 kappa), or of the line load where the whole face is loaded or endless
// (line_contact.hpp), F* = pi/kappa or, by unit length, pi/2.
// Source: eqs (20)-(26) of doi 10.1016/j.triboint.2013.01.017.
#pragma once

#include "contact/face_law.hpp"
#include "contact/hertz.hpp"
#include "contact/moes.hpp"

namespace gearfilm {

struct Scales {
  ContactSolids solids;        ///< R_x*, R_y, E' of the reference contact
  ContactOperation operation;  ///< w* [N], u_m* [m/s]
  Lubricant oil;
  HertzContact hertz;  ///< of the reference contact under w*

  double length = 0.0;        ///< a [m]: X, Y
  double pressure = 0.0;      ///< p_h [Pa]: P
  double thickness = 0.0;     ///< a^2/R_x* [m]: H
  double time = 0.0;          ///< t* [s]: T
  double lambda = 0.0;        ///< Reynolds number group [-]
  double C_h = 0.0;           ///< elastic deformation coefficient [-]
  double radius_ratio = 0.0;  ///< D = R_x*/R_y [-]
  double approach = 0.0;      ///< h_0n R_x*/a^2 [-], Hertz approach of the reference contact: its -H_0 when dry
  std::shared_ptr<const FaceLaw> face_law{};  ///< of the dry contact along a whole face, where there is one
  double static_force = 0.0;                  ///< F* [-], the integral of P that carries w*

  /// Force [N] of a dimensionless pressure integral.
  double force(double pressure_integral) const { return operation.load * pressure_integral / static_force; }
  /// I_n = m_ge/(R_x* t*^2 p_h) (26) [-] of an equivalent mass [kg].
  double inertia(double equivalent_mass) const;
};

Scales make_scales(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation);

}  // namespace gearfilm
