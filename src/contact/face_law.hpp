// How a dry contact along a whole face answers to its force: approach, largest half-width and pressure, and moment, as
// smooth functions of the force and of the radius across.
//
// Polynomials in ln F, made from contacts that were solved (elasticity/row_contact.hpp) at two radii, between which
// logarithms are linear in ln Rbar: what depends on the radius does so by a logarithm. Beyond the forces that were
// solved for the functions go on as powers of the force.
#pragma once

#include <array>
#include <vector>

namespace gearfilm {

/// One dry contact along a face, dimensionless.
struct FaceContact {
  double force = 0.0;
  double approach = 0.0;    ///< of the bodies, from gap zero in the middle of the face
  double half_width = 0.0;  ///< the largest of a row that is not beside an end
  double pressure = 0.0;    ///< the largest of these rows
  double arm = 0.0;         ///< of the resultant force, from the middle of the face
};

class FaceLaw {
public:
  /// Contacts of increasing forces, the same at both radii. nearest: the smallest gap, where the flanks meet first.
  FaceLaw(double nearest, std::array<double, 2> relative_radii,
          const std::array<std::vector<FaceContact>, 2>& contacts);

  FaceContact at_force(double force, double relative_radius) const;
  /// Approaches are counted from where the flanks meet.
  double approach(double force, double relative_radius) const;
  /// The gap there, less that of the middle of the face: at most zero.
  double nearest() const { return nearest_; }
  /// d(force)/d(approach).
  double stiffness(double force, double relative_radius) const;
  /// The force on a spring of a compliance, for any approach; zero where the bodies are apart.
  double force(double approach, double compliance, double relative_radius) const;

private:
  /// A quantity, or its ln, as a polynomial in ln F, and as a straight line beyond its ends.
  struct Curve {
    std::vector<double> coefficients;
    double low = 0.0, high = 0.0;

    double value(double log_force) const;
    double slope(double log_force) const;
  };
  static Curve fitted(const std::vector<FaceContact>& contacts, double FaceContact::*quantity, bool logarithm);
  struct AtRadius {
    Curve approach, half_width, pressure, arm;
  };
  double weight(double relative_radius) const;
  /// ln of the approach beyond `nearest`, and its derivative by ln F.
  double log_approach(double log_force, double part) const;
  double power(double log_force, double part) const;

  double nearest_;
  std::array<double, 2> log_radii_;
  std::array<AtRadius, 2> curves_;
};

}  // namespace gearfilm
