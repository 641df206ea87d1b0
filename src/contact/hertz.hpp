// Dry elastic point contact (Hertz) between bodies with reduced radii R_x (along entrainment) and R_y.
//
//   D = R_x/R_y = kappa^2 (K-E)/(E - kappa^2 K),  K, E complete elliptic integrals of modulus sqrt(1-kappa^2)
//   b^3 = 6 E w R/(pi kappa^2 E'),  a = kappa b,  p_h = 3 w/(2 pi a b),  1/R = 1/R_x + 1/R_y
//   approach = K [9/(2 E R)]^(1/3) [w kappa/(pi E')]^(2/3)
// Source: Johnson, Contact Mechanics (1985), ch. 4; with the notation of doi 10.1016/j.triboint.2013.01.017.
// a is the half-axis along x (entrainment), b along y; R_x > R_y (a > b) is solved with the axes exchanged.
#pragma once

#include <memory>

#include "contact/face.hpp"
#include "roughness/rough_surfaces.hpp"

namespace gearfilm {

/// 2/E' = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2 [Pa].
double reduced_modulus(double youngs_modulus_1, double poisson_ratio_1, double youngs_modulus_2,
                       double poisson_ratio_2);

/// The bodies of a contact.
struct ContactSolids {
  double radius_x = 0.0;               ///< R_x [m]
  double radius_y = 0.0;               ///< R_y [m]; infinite without crowning
  double reduced_modulus = 0.0;        ///< E' [Pa]
  std::shared_ptr<const Face> face{};  ///< the whole face, which is loaded; null where the contact ends within it
  bool line = false;                   ///< endless along the face, with loads by unit length
  std::shared_ptr<const RoughSurfaces> rough{};  ///< roughness that films see; null where they are smooth
};

/// Contact ellipse and pressure under a load w.
struct HertzContact {
  double ellipticity = 0.0;  ///< kappa = a/b [-]
  double a = 0.0;            ///< half-axis along x [m]
  double b = 0.0;            ///< half-axis along y [m]
  double pressure = 0.0;     ///< p_h [Pa]
  double approach = 0.0;     ///< h_0n [m]
};

/// Ellipticity kappa = a/b for D = R_x/R_y, to round-off. Throws InputError unless 1e-6 <= D <= 1e6.
double hertz_ellipticity(double radius_ratio);

/// Hertz solution for a load w [N] > 0; of a line contact, or beneath the mean line load of a face, that of
/// line_contact.hpp.
HertzContact hertz_contact(const ContactSolids& solids, double load);

/// Load [N] that gives the approach [m] of the two bodies; zero for approach <= 0. Inverse of hertz_contact.
double hertz_load(const ContactSolids& solids, double approach);

/// F of q F^(2/3) + c F = approach: of a contact with the force q^(-3/2) at unit approach, on a spring of compliance c,
/// in any consistent units; zero for approach <= 0.
double force_on_spring(double unit_force, double compliance, double approach);

/// Half-width of a line contact, b_l = sqrt(8 w_l R_x/(pi E')) [m]; w_l = load per unit length [N/m].
double hertz_line_half_width(double load_per_length, double radius_x, double reduced_modulus);

/// Point load [N] whose ellipse has the half-axis a = half_width along x (eq. (27) of the paper).
double equivalent_point_load(const ContactSolids& solids, double half_width);

}  // namespace gearfilm
