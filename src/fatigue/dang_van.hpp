// Dang Van's criterion of fatigue: the equivalent shear stress of a history of stresses.
//
//   DV = max_t [ tau(t) + alpha p_H(t) ] <= beta
// p_H is the hydrostatic stress, tau half the difference of the outer principal values of s(t) - c, s the deviator and
// c the centre of the smallest ball that holds the history of s, in the norm (s:s)^(1/2). As vectors deviators are
//   v = ( sqrt(3/2) s_xx, (s_yy - s_zz)/sqrt 2, sqrt 2 s_yz, sqrt 2 s_xz, sqrt 2 s_xy ) ,  |v|^2 = s:s .
// beta is the limit of reversed torsion tau_w, alpha = 3 (tau_w/sigma_w - 1/2) with that of reversed bending sigma_w:
// both then give DV = tau_w. (Dang Van 1993, doi 10.1520/STP24796S: second-hand, by its identities verified.)
//
// Where the material does not gain from compression (Desimone, Bernasconi and Beretta 2006: second-hand) alpha p_H
// counts as tension only. A constant residual stress sigma_r in x and y adds alpha 2 sigma_r/3 otherwise.
#pragma once

#include <span>
#include <vector>

#include "fatigue/smallest_ball.hpp"
#include "stress/equivalent_stress.hpp"

namespace gearfilm {

struct DangVanOptions {
  double alpha = 0.3;
  bool compression_helps = true;
};

/// v of a stress.
DeviatorPoint deviator(const Stress& stress);

/// DV of a history.
double dang_van(std::span<const Stress> history, const DangVanOptions& options);

/// A history with more states between those given at increasing times (or places): cubic, with the slopes of parabolas
/// through three states, and `parts` to a step. The ball's centre depends on where states are, by 1.3 % at 12 states to
/// a half-width of a contact without more.
std::vector<Stress> resampled(std::span<const double> times, std::span<const Stress> history, int parts);

/// The factor on all stresses of the load at which DV of load and residual stress (xx = yy) comes to a limit.
/// 0 or less: the residual stress exceeds it.
double dang_van_safety(double of_load, double limit, double residual_stress, double alpha);

}  // namespace gearfilm
