// What distinguishes a contact at one moment from the reference contact of the Scales, in numbers, and its dry
// counterpart.
#pragma once

#include <optional>

#include "contact/contact_law.hpp"
#include "contact/scales.hpp"
#include "gear/local_profile.hpp"
#include "gear/uneven_flank.hpp"
#include "roughness/contact_texture.hpp"

namespace gearfilm {

/// Where flanks that have a shape of their own along the contact come nearest to each other.
struct NearestPoint {
  double X = 0.0;
  double drop = 0.0;                        ///< of the gap, from X = 0 in the middle of the face [-]
  std::optional<double> relative_radius{};  ///< of the parabola there, R_x/R_x*; absent: as without
  /// Largest ratio, either way, of R_x of that parabola to R_x of the involutes.
  static constexpr double widest_ratio = 10.0;

  bool operator==(const NearestPoint&) const = default;
};

struct ContactConditions {
  double relative_radius = 1.0;   ///< Rbar = R_x/R_x* [-]
  double entrainment = 1.0;       ///< U = u_m/u_m* [-]
  double sliding = 0.0;           ///< S = (u_1 - u_2)/u_m* [-]
  double gap_offset = 0.0;        ///< added to H: tip relief, pitch error [-]
  LocalProfile local{};           ///< added to H along X
  UnevenProfile beside_middle{};  ///< added to H beside the middle of the face
  ContactTexture texture{};       ///< taken from H at every node
  NearestPoint nearest{};         ///< with it

  // What a dry contact takes it for.
  double dry_radius() const { return nearest.relative_radius.value_or(relative_radius); }
  double dry_gap() const { return gap_offset - nearest.drop; }

  bool operator==(const ContactConditions&) const = default;
};

/// Finds the nearest point of conditions with a local profile, to a tenth of the Hertz half-axis.
NearestPoint nearest_point(const Scales& scales, const ContactConditions& conditions);

/// The reference contact's solids with the radius R_x of the moment.
ContactSolids solids_of(const Scales& scales, const ContactConditions& conditions);

/// Pressure integral of an elliptic dry contact that one unit of H presses together, without its offset [-].
double force_at_unit_approach(const Scales& scales, const ContactConditions& conditions);

/// How the dry contact answers to an approach [-].
ContactLaw contact_law(const Scales& scales, const ContactConditions& conditions);

/// Hertz contact of the given radius under the pressure integral F (in units of F*: the reference load) [SI]. Along a
/// whole face a is the largest half-width of a row that is not beside an end, the pressure likewise, and the approach
/// is counted from where the flanks meet.
HertzContact dry_contact(const Scales& scales, const ContactConditions& conditions, double pressure_integral);

}  // namespace gearfilm
