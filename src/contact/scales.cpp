// The scales of the dimensionless problem, eqs (20)-(26) of doi 10.1016/j.triboint.2013.01.017:
//   X = x/a, P = p/p_h, H = h R_x*/a^2, T = t u_m*/a
// Without an ellipse a and p_h are those of the mean line load: then 2 pi C_h = 1.
#include "contact/scales.hpp"

#include <cassert>
#include <numbers>

#include "contact/line_contact.hpp"

namespace gearfilm {

double Scales::inertia(double equivalent_mass) const {
  return equivalent_mass / (solids.radius_x * time * time * pressure);
}

Scales make_scales(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation) {
  using std::numbers::pi;
  assert(operation.entrainment_velocity > 0.0);
  Scales scales;
  scales.solids = solids;
  scales.operation = operation;
  scales.oil = oil;
  const bool ellipse = has_ellipse(solids);
  scales.hertz = hertz_contact(solids, operation.load);

  const double a = scales.hertz.a;
  const double R_x = solids.radius_x;
  scales.length = a;
  scales.pressure = scales.hertz.pressure;
  scales.thickness = a * a / R_x;
  scales.time = a / operation.entrainment_velocity;
  // lambda = 12 u_m* eta_0 R_x*^2/(a^3 p_h), C_h = 2 p_h R_x*/(pi E' a), F* = 2 pi/(3 kappa)
  scales.lambda = 12.0 * operation.entrainment_velocity * oil.viscosity * R_x * R_x / (a * a * a * scales.pressure);
  scales.C_h = 2.0 * scales.pressure * R_x / (pi * solids.reduced_modulus * a);
  scales.radius_ratio = R_x / solids.radius_y;
  scales.approach = scales.hertz.approach / scales.thickness;
  const double width = solids.line ? a : a * a;
  scales.static_force =
      ellipse ? 2.0 * pi / (3.0 * scales.hertz.ellipticity) : operation.load / (scales.pressure * width);
  return scales;
}

}  // namespace gearfilm
