// Flash temperature and the safeties against scuffing, after ISO/TS 6336-20 (flash) and -21 (integral).
//
// A band of semi-elliptical heat on two fast half-spaces, b half its width, w the load by face width (Blok):
//   T_fl = 1.11 mu w |u_1 - u_2| / [ (2 b)^(1/2) (B_1 u_1^(1/2) + B_2 u_2^(1/2)) ] ,  B = (k rho c)^(1/2)
// 1.11 is the largest value over the band (1.11154 by quadrature). With the oil's temperature T_oil and the temperature
// T_S at which it scuffs, an input from tests,
//   S_B = (T_S - T_oil)/(T_Bmax - T_oil) ,   S_int = T_Sint/(T_M + C_2 <T_fl>) in degrees Celsius, C_2 = 1.5
// <> is the mean over the path of contact, here of the march itself; C_2 is second-hand. Left out: factors X.
#pragma once

namespace gearfilm {

/// One side of a contact: u [m/s] and B [J/(m^2 K s^0.5)].
struct HeatedSide {
  double velocity = 0.0;
  double effusivity = 0.0;
};

/// line_load: mu w [N/m]; half_width: b [m]. [K]
double flash_temperature(double friction_load, double half_width, const HeatedSide& pinion, const HeatedSide& wheel);

/// Temperatures in K.
double flash_safety(double scuffing_temperature, double oil_temperature, double largest_temperature);
double integral_temperature(double bulk_temperature, double mean_flash_temperature);
double integral_safety(double scuffing_temperature, double integral_temperature);

}  // namespace gearfilm
