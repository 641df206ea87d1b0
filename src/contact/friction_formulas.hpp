// Formulas for friction, flash temperature and heating of the inlet, for comparison with what is computed.
//
// Schlenk (as ISO/TR 14179-2 and textbooks have it), mean over the mesh, N, mm, m/s, mPa s, um:
//   mu = 0.048 [(F_bt/b)/(v_sumC rho_redC)]^0.2 eta^-0.05 Ra^0.25 X_L
// Xu, Kahraman, Anderson and Maddock 2007 (doi 10.1115/1.2359470), fitted to a 75W90 oil; P [GPa], nu [cP], R [m],
// Rq [um], S = u_s/u_m:
//   mu = e^f P^b2 |S|^b3 u_m^b6 nu^b7 R^b8,  f = b1 + b4 |S| P lg nu + b5 e^(-|S| P lg nu) + b9 e^Rq
// Blok, bodies of one material: T_f = 1.11 mu w' |sqrt(u_1) - sqrt(u_2)|/(B sqrt(2 a)), w' = Int p dx for y = 0
// Thermal factors of the film, L_T = beta eta_0 u_m^2/k, S = |u_s|/u_m:
//   Murch and Wilson 1975, rolling:  3.94/(3.94 + L_T^0.62)
//   Gupta, Cheng et al. 1992:        (1 - 13.2 (p_h/E') L_T^0.42)/(1 + 0.213 (1 + 2.23 S^0.83) L_T^0.64)
// All of them second-hand: no source was looked up.
#pragma once

namespace gearfilm {

/// line_load: F_bt/b [N/m]; sum_velocity: v_sumC [m/s]; radius: reduced, at the pitch point [m]; viscosity [Pa s];
/// roughness: Ra [m].
double schlenk_friction(double line_load, double sum_velocity, double radius, double viscosity, double roughness);

/// pressure: Hertz's [Pa]; slide_ratio: S, of either sign; [m/s], [Pa s]; radius: R_x [m]; roughness: Rq [m].
double xu_kahraman_friction(double pressure, double slide_ratio, double entrainment_velocity, double viscosity,
                            double radius, double roughness);

/// friction_load: mu w' [N/m]; u_1, u_2 [m/s]; effusivity: B [J/(m^2 K s^0.5)]; half_width: a [m]. Result in [K].
double blok_flash_temperature(double friction_load, double u_1, double u_2, double effusivity, double half_width);

/// L_T [-].
double thermal_loading(double temperature_viscosity, double viscosity, double entrainment_velocity,
                       double conductivity);
double murch_wilson_factor(double loading);
/// relative_pressure: p_h/E'. At high pressures far below computed factors; never below zero here.
double gupta_factor(double loading, double relative_pressure, double slide_ratio);

}  // namespace gearfilm
