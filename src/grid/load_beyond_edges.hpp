// Load that oil carries beyond the sides and the outlet of a moving contact's domain, and edges that leave little out.
//
// A rigid cylinder of radius R_x carries on each length of a strip of gap h, in oil of one viscosity,
//   4.9 eta_0 u_m R_x/h  by its wedge,   3 sqrt(2) pi eta_0 V (R_x/h)^(3/2)  by its approach with the velocity V.
// Beyond the tips of a slender ellipse strips have H = H_c + c (Y^2 - 1), c = D/(2 kappa^2), Y = y/b. With q^2 = 1 -
// H_c/c and V in a^2/(R_x t*) they carry, of the contact's load, beyond |y| = Y b
//   0.39 lambda {ln[(Y + q)/(Y - q)]/(2 c q) + 2.7 V [Y/sqrt(Y^2 - q^2) - 1]/(c^(3/2) q^2)} .
// Behind the contact the pressure of the approach, 6 eta_0 V R_x/h^2, carries beyond X
//   0.48 lambda V Int dX/H^2 ,   H = H_c + [X sqrt(X^2 - 1) - ln(X + sqrt(X^2 - 1))]/2 ,
// with the V of swings or, where it is larger, of a tooth that enters along its mate's relief.
// Assumptions: no strip feels the next one, H_c everywhere as the film formula has it. Where domains were extended, the
// largest forces of eight periodic pairs changed by at most 1.3 times the first and a quarter of the second
// (docs/notes/2026-11-edges-and-forces.md), forces on entering contacts in thick oil by a tenth of it
// (docs/notes/2026-11-thick-oil-in-motion.md).
#pragma once

#include "grid/domain.hpp"

namespace gearfilm {

class LoadBeyondEdges {
public:
  /// V with which the flanks of a pair that swings approach each other, and those of an entering contact.
  LoadBeyondEdges(const Scales& scales, double swinging, double entering = 0.0);

  /// Beyond both sides of an ellipse, y in units of b.
  double sides(double y) const;
  /// Behind the outlet.
  double outlet(double X) const;

private:
  double lambda_, swinging_, fastest_, film_;
  double rise_;   ///< c
  double blunt_;  ///< q
};

/// The domain with an outlet that leaves 1.5 % of the load out.
Domain carrying_behind(Domain domain, const LoadBeyondEdges& load);
/// The domain of an ellipse with sides that leave 0.2 % of the load out, where the face is wide enough; half_face in
/// units of b.
Domain carrying_beside(Domain domain, const LoadBeyondEdges& load, double half_face);

}  // namespace gearfilm
