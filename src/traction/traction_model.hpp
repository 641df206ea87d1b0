// What friction and heat in a film depend on besides the film itself: shear law, oil and bodies as heat meets them.
//
// u_1 is the velocity of the pinion's surface (of body 1 of a bare contact), u_2 that of the wheel's, both along the
// entrainment x; z goes from the wheel, z = 0, to the pinion, z = h. All of this room is in SI units.
#pragma once

#include <array>
#include <optional>

#include "lubricant/shear_law.hpp"
#include "lubricant/thermal_oil.hpp"

namespace gearfilm {

/// A body on which the film runs.
struct HeatedBody {
  double temperature = 363.15;   ///< far from the contact, T_b [K]
  double conductivity = 47.0;    ///< k [W/(m K)]
  double density = 7850.0;       ///< rho [kg/m^3]
  double heat_capacity = 460.0;  ///< c [J/(kg K)]

  /// B = sqrt(k rho c) [J/(m^2 K s^0.5)].
  double effusivity() const;
};

/// The energy equation across the film (film_heat.hpp).
struct HeatOptions {
  ThermalOil oil;
  int points = 17;           ///< across the film, odd
  bool couple_film = false;  ///< the film feels its heat
};

struct TractionModel {
  ShearLaw law;
  std::array<HeatedBody, 2> bodies;  ///< pinion, wheel
  std::optional<HeatOptions> heat;   ///< absent: friction of an isothermal film

  double boundary_coefficient = 0.11;  ///< mu_b of asperities; an assumption

  bool shear_couples_film = false;  ///< the film feels the shear law

  bool heats_film() const { return heat && heat->couple_film; }
  /// The flow in the film is corrected for heat or shear.
  bool corrects_film() const { return shear_couples_film || heats_film(); }
};

/// [m/s].
struct SurfaceVelocities {
  double mean = 0.0;     ///< u_m
  double sliding = 0.0;  ///< u_s = u_1 - u_2: given as it is, since the difference of both would be lost in round-off

  double pinion() const { return mean + 0.5 * sliding; }  ///< u_1
  double wheel() const { return mean - 0.5 * sliding; }   ///< u_2
};

}  // namespace gearfilm
