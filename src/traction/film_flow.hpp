// The flow in a film whose temperature differs across it, at some places side by side.
//
//   J_n = Int_0^h z^n/eta dz,  z_ = J_1/J_0                       eta = eta(p, T(z))
//   flow = u_m h + u_s (h/2 - z_) + q_P,  q_P = -p_x (J_2 - J_1^2/J_0) = -F h^3 p_x/(12 eta(p, T_0))
//   u(z) = u_2 + u_s Int_0^z n dz'/h + G Int_0^z (z' - z_)/eta dz',   n = (1/eta)/mean(1/eta)
//   Phi(z) = G^2 (z - z_)^2/eta + G (z - z_)(tau_m/eta + gamma'),     G = -12 eta(p, T_0) q_P/(F h^3)
//   with S of a shear law that is not Newton's (sheared_flow.hpp)
//   Phi(z) = G^2 (z - z_)^2/(S eta) + G (z - z_)(tau_m/eta + gamma'/S)
//   rho w(z) = -d/dx Int_0^z rho u dz',  less the part that leaves by the sides, taken as leaving evenly
// w is across lines of constant z/h. q_P is given: p_x belongs to the F with which Reynolds' equation was solved last,
// and the flow is what it conserves; so the heat falls as the oil warms. Where pressure drives the oil forwards, out of
// the contact, the profile is a parabola at the mean of ln eta: with the profile of the moment Newton's method does not
// settle there. Yang and Wen 1990, J. Tribology 112; Najji, Bou-Said and Berthe 1989, J. Tribology 111 (neither looked
// up).
#pragma once

#include <cstdint>
#include <vector>

#include "traction/film_lanes.hpp"

namespace gearfilm {

/// Which flow carries the heat: that of an isothermal film, or the film's own.
enum class FlowProfile : std::uint8_t { isothermal, thermal };

class OwnFlow {
public:
  using Lanes = FilmLanes;

  /// Points across the film; nothing is kept for others than FlowProfile::thermal.
  OwnFlow(const std::vector<double>& weights, const std::vector<double>& places);

  /// The oil across the film: 1/eta to ambient, d ln eta/dT, ln(eta/eta_0), n, a point each.
  struct Oil {
    const std::vector<Lanes>&fluidity, &slope, &log_viscosity, &share;
  };
  /// The film as Reynolds' equation has it.
  struct Film {
    const Lanes &full_film, &thickness, &log_viscosity, &poiseuille_flow, &driven_flow, &stress, &shear_factor;
    double ambient_viscosity;  ///< eta_0 [Pa s]
    const Lanes& sliding;      ///< u_s [m/s]
  };
  void update(const Oil& oil, const Film& film);

  // Of the last update.
  Lanes log_factor{};       ///< ln F
  Lanes centre{};           ///< z_/h
  std::vector<Lanes> heat;  ///< Phi_k [W/m^3]
  // Its derivative, d Phi_k/d T_j = -diagonal_k delta_kj - column_k row_j.
  std::vector<Lanes> diagonal, column, row;
  std::vector<Lanes> poiseuille;  ///< the part of u_k that pressure drives [m/s]

private:
  std::vector<double> weights_, places_, bent_;
  double second_moment_ = 0.0;  ///< 1/12 on these points
};

}  // namespace gearfilm
