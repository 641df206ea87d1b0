// The forces of dry contacts of a mesh: elastic contacts (contact/contact_law.hpp) on teeth that bend.
//
//   approach(F_k) + c_kk F_k = -H_0 - e_k - sum_{j != k} c_kj F_j
// Of ellipses approach = (F/k)^(2/3), k the force at unit approach: ln k is a smooth function of ln R_x, and a series
// has it to round-off over the radii of a path of contact.
#pragma once

#include <vector>

#include "gear/chebyshev.hpp"
#include "mesh/mesh_model.hpp"

namespace gearfilm {

class DryForce {
public:
  explicit DryForce(const MeshModel& mesh);

  /// The law of a contact [-]; k to a relative error below 1e-12.
  ContactLaw law(const ContactConditions& conditions) const;

private:
  std::shared_ptr<const FaceLaw> face_;
  Chebyshev<20> logarithm_;  ///< of k over ln Rbar
};

/// The dry contacts present at one time, and what they do together at any H_0.
class DryContacts {
public:
  DryContacts(const DryForce& force, const MeshModel& mesh, const std::vector<int>& numbers, double T);

  /// Whether others answer alike, but for round-off.
  bool same_as(const DryContacts& others) const;

  /// Takes gaps with which the contacts have these forces where they are displaced like this: those of films, which
  /// keep their thickness.
  void stand_for(const std::vector<double>& forces, const std::vector<double>& displacements);
  /// Pressure integrals of the contacts [-]; zero where the bodies are apart.
  std::vector<double> forces(double H0) const;
  /// Forces as above, where forces nearby are known.
  std::vector<double> forces_near(double H0, const std::vector<double>& guess) const;
  double total_force(double H0) const;
  /// Approach of the contact that a rigid pair would press most; negative where all are apart [-].
  double largest_approach(double H0) const;
  /// d(total force)/d(-H_0) at these forces [-].
  double stiffness(const std::vector<double>& forces) const;
  /// H_0 at which they carry a load [-] together.
  double balance(double load) const;

private:
  struct Contact {
    double gap = 0.0;  ///< e_k [-]
    ContactLaw law;
  };

  /// Forces of at most two ellipses that stay in contact, from nearby; false, and as they were, where these are none.
  bool follow(double H0, std::vector<double>& forces) const;
  /// Approach of a contact at H_0, less what the others' forces take of it.
  double approach(std::size_t contact, double H0, const std::vector<double>& forces) const;

  std::vector<Contact> contacts_;
  Compliance compliance_;
  bool coupled_;
  bool elliptic_;
};

}  // namespace gearfilm
