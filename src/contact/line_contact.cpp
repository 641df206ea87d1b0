#include "contact/line_contact.hpp"

#include <cmath>
#include <numbers>

#include "contact/film_formulas.hpp"

namespace gearfilm {

using std::numbers::pi;

HertzContact line_contact(const ContactSolids& solids, double load_per_length) {
  const double a = hertz_line_half_width(load_per_length, solids.radius_x, solids.reduced_modulus);
  return {.ellipticity = 0.0, .a = a, .b = HUGE_VAL, .pressure = 2.0 * load_per_length / (pi * a), .approach = 0.0};
}

HertzContact finite_line_contact(const ContactSolids& solids, double load) {
  const double width = solids.face->width;
  HertzContact contact = line_contact(solids, load / width);
  contact.b = 0.5 * width;
  contact.ellipticity = contact.a / contact.b;
  contact.approach = contact.a * contact.a / (2.0 * solids.radius_x) * (std::log(2.0 * width / contact.a) + 0.5);
  return contact;
}

bool has_ellipse(const ContactSolids& solids) { return !solids.line && !solids.face; }

double moes_line_central(const ContactSolids& solids, const Lubricant& oil, double load_per_length,
                         double entrainment_velocity) {
  const double stiffness = solids.reduced_modulus * solids.radius_x;  // E' R_x [N/m]
  const double speed = 2.0 * oil.viscosity * entrainment_velocity / stiffness;
  const double M = load_per_length / stiffness / std::sqrt(speed),
               L = oil.pressure_viscosity * solids.reduced_modulus * std::pow(speed, 0.25);
  const double H_RI = 3.0 / M, H_EI = 2.621 * std::pow(M, -0.2);
  const double H_RP = 1.287 * std::pow(L, 2.0 / 3.0), H_EP = 1.311 * std::pow(M, -0.125) * std::pow(L, 0.75);
  const double q = 0.2 * (7.0 + 8.0 * std::exp(-2.0 * H_EI / H_RI));
  const double isoviscous = std::pow(H_RI, 7.0 / 3.0) + std::pow(H_EI, 7.0 / 3.0);
  const double piezoviscous = std::pow(H_RP, -3.5) + std::pow(H_EP, -3.5);
  const double H = std::pow(std::pow(isoviscous, 3.0 * q / 7.0) + std::pow(piezoviscous, -2.0 * q / 7.0), 1.0 / q);
  const double density = relative_density(oil, line_contact(solids, load_per_length).pressure).value;
  return solids.radius_x * std::sqrt(speed) * H / density;
}

double load_per_length(const ContactSolids& solids, const ContactOperation& operation) {
  return solids.line ? operation.load : operation.load / solids.face->width;
}

double expected_central_film(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation) {
  if (has_ellipse(solids)) return nijenbanning_venner_moes_central(solids, oil, operation);
  return moes_line_central(solids, oil, load_per_length(solids, operation), operation.entrainment_velocity);
}

}  // namespace gearfilm
