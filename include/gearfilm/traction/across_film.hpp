// The energy equation across the film at some places side by side.
//
//   rho c u(z) (T - T_upstream)/h_x = d/dz(k dT/dz) + tau_m gamma'(z) + Phi(z)
//   gamma'(z) = u_s n(z)/h,  n = (1/eta)/mean(1/eta),  eta = eta(p, T(z)),  tau_m of the law at u_s/(h mean(1/eta))
//   Phi(z) = (z - h/2)^2 p_x^2/eta(p, T_0)
//   u(z) = u_2 + u_s Int_0^z n dz'/h + 6 (q_P/h) (z/h)(1 - z/h), cut at zero from below, then scaled to the mean flow
//   q_i = (T_i - base_i) conductance_i                                heat into the wall i, and its temperature
// Finite volumes, the walls' cells being half as wide: what is generated goes into the walls or away with the oil, to
// round-off. Newton's method for the temperatures T_k: a tridiagonal matrix plus one of rank one, since tau_m sees all
// of them. SI units.
#pragma once

#include <array>
#include <vector>

#include "gearfilm/traction/traction_model.hpp"

namespace gearfilm {

class AcrossFilm {
public:
  static constexpr int lanes = 8;  ///< places side by side, for vector instructions
  using Lanes = std::array<double, lanes>;

  /// conductances: of pinion and wheel [W/(m^2 K)].
  AcrossFilm(const ShearLaw& law, const Lubricant& oil, const HeatOptions& heat, const SurfaceVelocities& velocities,
             const std::array<double, 2>& conductances);

  // To be given for every lane.
  Lanes wet{};              ///< 1; 0 where there is neither shear nor Poiseuille heat
  Lanes pressure{};         ///< p [Pa]
  Lanes thickness{};        ///< h [m]
  Lanes log_viscosity{};    ///< ln(eta/eta_0) at T_0
  Lanes half_gradient{};    ///< h p_x/2 [Pa]
  Lanes poiseuille_heat{};  ///< 12 times the mean of Phi [W/m^3]
  Lanes poiseuille_flow{};  ///< q_P/h [m/s]
  Lanes flow{};             ///< mean of u(z) [m/s]
  Lanes carried{};          ///< rho c/h_x [J/(m^4 K)]
  Lanes conductivity{};     ///< k [W/(m K)]
  Lanes base_pinion{};      ///< wall temperatures without heat [K]
  Lanes base_wheel{};
  std::vector<Lanes> upstream;  ///< T_k there, the wheel's wall first [K]

  int points() const { return static_cast<int>(weights_.size()); }
  /// Finds the temperatures, from those upstream, to 1e-6 K; lanes where that takes too long count as missed. Throws
  /// SolveError where one is not finite.
  void solve();
  bool missed(int lane) const;

  // Of the solution.
  const std::vector<Lanes>& temperatures() const { return T_; }  ///< T_k [K]
  const Lanes& stress() const { return stress_; }                ///< |tau_m| [Pa]
  double heat_pinion(int lane) const { return (T_.back()[lane] - base_pinion[lane]) * conductances_[0]; }  ///< [W/m^2]
  double heat_wheel(int lane) const { return (T_.front()[lane] - base_wheel[lane]) * conductances_[1]; }
  double heat_generated(int lane) const;
  double heat_carried(int lane) const;
  double mean_temperature(int lane) const;

private:
  template <ViscosityLaw law>
  void shear();
  void set_transport();
  double improve(double resistance);

  ShearLaw law_;
  ViscosityLaw viscosity_law_;
  ViscosityByTemperature viscosity_;
  double log_ambient_;
  SurfaceVelocities velocities_;
  std::array<double, 2> conductances_;
  std::vector<double> weights_;  ///< w_k, of a mean over the film
  std::vector<double> places_;   ///< z_k/h
  std::vector<double> bent_;     ///< Phi_k h^2/... of poiseuille_heat
  std::vector<Lanes> T_;
  std::vector<Lanes> transport_;                 ///< rho c u/h_x
  std::vector<Lanes> fluidity_, slope_, share_;  ///< 1/eta relative to ambient, d ln eta/dT, n
  std::vector<Lanes> diagonal_, right_, bordered_;
  Lanes stress_{}, by_rate_{};
  Lanes change_{};  ///< largest of the last iteration
};

}  // namespace gearfilm
