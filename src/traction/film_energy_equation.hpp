// The energy equation across the film at some places side by side.
//
//   rho c dT/dt + rho c u(z) dT/dx + rho c w(z) dT/dz = d/dz(k dT/dz) + tau_m gamma'(z) + Phi(z)
//   gamma'(z) = u_s n(z)/h,  n = (1/eta)/mean(1/eta),  eta = eta(p, T(z)),  tau_m of the law at u_s/(h mean(1/eta))
//   dT/dx = (T - T_upstream)/step, or towards downstream where u < 0
//   q_i = (T_i - base_i) conductance_i                                heat into the wall i, and its temperature
// The flow that pressure drives, q_P, is given. In a film that does not feel its heat (FlowProfile::isothermal)
//   u(z) = u_2 + u_s Int_0^z n dz'/h + 6 (q_P/h) (z/h)(1 - z/h), cut at zero from below, then scaled to the mean flow
//   Phi(z) = (z - h/2)^2 p_x^2/eta(p, T_0),  w = 0
// In one that does (FlowProfile::thermal), film_flow.hpp. Finite volumes, the walls' cells being half as wide: what is
// generated goes into the walls or away with the oil, to round-off. Newton's method for the temperatures T_k: a
// tridiagonal matrix plus one of rank one, since tau_m sees all of them, and another where Phi does. SI units.
#pragma once

#include <array>
#include <vector>

#include "traction/traction_model.hpp"
#include "traction/film_flow.hpp"

namespace gearfilm {

class FilmEnergyEquation {
public:
  static constexpr int lanes = film_lanes;  ///< places side by side, for vector instructions
  using Lanes = FilmLanes;

  FilmEnergyEquation(const ShearLaw& law, const Lubricant& oil, const HeatOptions& heat,
                     FlowProfile kind = FlowProfile::isothermal);

  // To be given for every lane.
  Lanes full_film{};        ///< 1; 0 where there is neither shear nor Poiseuille heat
  Lanes pressure{};         ///< p [Pa]
  Lanes thickness{};        ///< h [m]
  Lanes log_viscosity{};    ///< ln(eta/eta_0) at T_0
  Lanes half_gradient{};    ///< h p_x/2 [Pa]
  Lanes poiseuille_flow{};  ///< q_P/h [m/s]
  Lanes driven_flow{};      ///< what p_x would drive through oil as viscous as at the place [m/s]
  Lanes carried{};          ///< rho c/step [J/(m^4 K)]
  Lanes conductivity{};     ///< k [W/(m K)]
  Lanes base_pinion{};      ///< wall temperatures without heat [K]
  Lanes base_wheel{};
  Lanes conductance_pinion{};  ///< from the walls into the bodies [W/(m^2 K)]
  Lanes conductance_wheel{};
  Lanes mean_velocity{};        ///< u_m [m/s]
  Lanes sliding{};              ///< u_s [m/s]
  std::vector<Lanes> upstream;  ///< T_k there, the wheel's wall first [K]
  std::vector<Lanes> before;    ///< T_k of a guess, which makes u(z) of a film that feels its heat
  // Of a film that does not feel its heat, and of a cavitated one.
  Lanes poiseuille_heat{};  ///< 12 times the mean of Phi [W/m^3]
  Lanes flow{};             ///< mean of u(z) [m/s]
  // Of a film that does.
  Lanes shear_factor{};           ///< S of sheared_flow.hpp
  Lanes stored{};                 ///< rho c over the time step [W/(m^3 K)]; 0 at rest
  std::vector<Lanes> earlier;     ///< T_k a time step ago [K]
  std::vector<Lanes> downstream;  ///< T_k there [K]
  std::vector<Lanes> arriving;    ///< what h u_k rho c/h_x is less by from upstream on, over step_factor [W/(m^2 K)]
  Lanes step_factor{};            ///< 1.5 of steps of second order, else 1
  std::vector<Lanes> upstream_factor;  ///< the same of T_k
  std::vector<Lanes> downstream_factor;

  int points() const { return static_cast<int>(weights_.size()); }
  /// Finds the temperatures, from the guess, to 1e-9 K; lanes where that takes too long count as unconverged. Throws
  /// SolveError where one is not finite.
  void solve();
  bool unconverged(int lane) const;

  // Of the solution.
  const std::vector<Lanes>& temperatures() const { return T_; }  ///< T_k [K]
  const Lanes& stress() const { return stress_; }                ///< |tau_m| [Pa]
  double heat_pinion(int lane) const {
    return (T_.back()[lane] - base_pinion[lane]) * conductance_pinion[lane];
  }  ///< [W/m^2]
  double heat_wheel(int lane) const { return (T_.front()[lane] - base_wheel[lane]) * conductance_wheel[lane]; }
  const Lanes& heat_generated() const { return heat_generated_; }  ///< [W/m^2]
  const Lanes& heat_carried() const { return heat_carried_; }
  const Lanes& mean_temperature() const { return mean_temperature_; }  ///< [K]
  const Lanes& largest_temperature() const { return largest_temperature_; }
  /// ln of eta |u_s|/h, eta the harmonic mean over the film [ln Pa].
  double log_newtonian(int lane) const { return log_newtonian_[lane]; }
  // Of a film that feels its heat.
  const OwnFlow& own_flow() const { return own_; }
  const std::vector<Lanes>& speeds() const { return speed_; }  ///< u_k [m/s]

private:
  template <EvaluatesViscosity Viscosity>
  void find_viscosities(Viscosity viscosity);
  void follow_viscosities();
  void shear();
  void set_transport();
  void set_own_transport();
  void update(bool sheared, int iteration);
  template <bool own>
  void assemble(double resistance);
  template <bool own>
  void correct();
  template <bool own>
  double improve(double resistance);
  template <bool own>
  void take_stock();

  ShearLaw law_;
  ViscosityEvaluator viscosity_;
  double log_ambient_;
  FlowProfile flow_;
  std::vector<double> weights_;  ///< w_k, of a mean over the film
  std::vector<double> places_;   ///< z_k/h
  std::vector<double> bent_;     ///< Phi_k h^2/... of poiseuille_heat
  OwnFlow own_;
  std::vector<Lanes> T_, source_;     ///< T_k, and where it comes from
  std::vector<Lanes> speed_;          ///< u_k
  std::vector<Lanes> transport_;      ///< w_k h rho c |u|/step
  std::vector<Lanes> below_, above_;  ///< conduction, and the flow across, from the neighbours [W/(m^2 K)]
  std::vector<Lanes> log_viscosities_, fluidity_, slope_, share_;  ///< ln eta, 1/eta to ambient, d ln eta/dT, n
  std::vector<Lanes> diagonal_, right_, bordered_, second_;
  Lanes stress_{}, by_rate_{}, log_newtonian_{};
  Lanes by_stress_{}, by_heat_{};  ///< parts of rank one of the last change
  Lanes heat_generated_{}, heat_carried_{}, mean_temperature_{}, largest_temperature_{};
  Lanes change_{};  ///< largest of the last iteration
};

}  // namespace gearfilm
