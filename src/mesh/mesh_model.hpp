// A gear pair in mesh, as films, dry contacts, marches and modes all see it: which contacts there are at a time, what
// each of them is like, and what they move.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include "elasticity/compliance.hpp"
#include "fatigue/fatigue_model.hpp"
#include "gear/teeth.hpp"
#include "mesh/contact_path.hpp"
#include "mesh/mesh_train.hpp"
#include "mesh/meshed_contact.hpp"
#include "mesh/motion.hpp"
#include "mesh/natural_frequency.hpp"
#include "mesh/prescribed_load.hpp"
#include "rating/rating_model.hpp"
#include "roughness/archard.hpp"
#include "traction/film_stress.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

/// g_i = m_ge R_bi^2/I_i, by which forces on either gear count in the motion; together 1.
struct InertiaShares {
  double pinion = 0.0;
  double wheel = 0.0;
};

struct MeshModel {
  Scales scales;
  ContactPath path;
  double inertia = 0.0;                  ///< I_n; 0: quasi-static balance
  std::optional<PrescribedLoad> load{};  ///< of a single contact, in the place of those beside it
  Teeth teeth{};
  std::shared_ptr<const std::array<Topography, 2>> topography{};  ///< heights of both flanks; none: smooth
  double stiffness = 0.0;                       ///< of the dry mesh at the pitch point (static_mesh.hpp) [-]
  double tooth_force = 0.0;                     ///< T_g1/R_b1, which the reference load stands for [N]
  std::optional<TractionModel> traction{};      ///< absent: no friction is computed
  std::optional<double> roughness{};            ///< of both flanks together [m]
  std::optional<WearCoefficients> wear{};       ///< absent: no wear is computed
  std::optional<StressModel> stress{};          ///< absent: no stresses below films are computed
  std::optional<FatigueModel> fatigue{};        ///< absent: fatigue of flanks is not judged
  std::shared_ptr<const RatingModel> rating{};  ///< null: the pair is not rated
  std::optional<InertiaShares> friction_couples_dynamics{};  ///< absent: friction does not act on the motion
  int pattern = 1;                                           ///< mesh periods after which the same teeth meet again
  int order = 1;                                             ///< patterns after which a periodic motion repeats
  std::shared_ptr<const MeshTrain> train{};                  ///< absent: rigid supports

  /// Degrees of freedom of the motion.
  Eigen::Index freedoms() const { return train ? train->freedoms() : 1; }
  /// A motion of the flanks alone, in the drive train: with the displacements of least energy, and the velocities that
  /// a blow between the flanks gives. Whole motions stay as they are.
  Motion in_train(const Motion& motion) const;

  /// A contact at time T, and one at a place xi [m] at the first speed.
  MeshedContact contact(int number, double T) const;
  MeshedContact contact_at(int number, double xi) const;
  /// c_kj of the contacts of these numbers at time T: of H by the force F [-].
  Compliance compliance(std::span<const int> numbers, double T) const;
  /// Whether films feel their heat or their shear.
  bool corrects_films() const { return traction && traction->corrects_film(); }
  /// Whether the bodies have no inertia and rest on all contacts.
  bool in_balance() const { return inertia == 0.0 && !load; }
  /// The share f of the static force from T on, up to where its law changes; absent where contacts share by themselves.
  std::optional<LoadSharing::Piece> share_from(double T) const;

  /// The period of a periodic motion, in mesh periods and in T, and when one begins next from T on.
  int periods() const { return order * pattern; }
  double period() const { return periods() * path.mesh_period(); }
  double next_period(double T) const { return period() * std::ceil(T / period() - 1e-9); }

  /// The stiffness of the dry mesh at the pitch point, k_el [N/m].
  double stiffness_si() const { return scales.force(stiffness) / scales.thickness; }
  /// f_n of the pair on that stiffness [1/t*].
  double frequency() const { return natural_frequency(stiffness, inertia); }
  /// That frequency in Hz.
  double frequency_si() const { return frequency() / scales.time; }
  /// Weight of V_0 in the norm of a motion: half a free oscillation, in which V_0 becomes a way, or 1 where that is
  /// less.
  double velocity_weight() const { return inertia > 0.0 ? std::min(1.0, 0.5 / frequency()) : 1.0; }
  /// Norm of a change of the motion, the largest of displacements and of velocities with their weight.
  double weighted_norm(const Motion& change) const { return length(weighted(change, velocity_weight())); }
  /// f_m [Hz].
  double mesh_frequency_si() const { return 1.0 / (scales.time * path.mesh_period()); }

  /// Power that the tooth force transmits [W].
  double transmitted_power() const { return tooth_force * path.line().travel_velocity(path.pinion_speed()); }
  /// The tooth force over the reference load [-]: 1 but for a point load that stands for a line contact.
  double load_factor() const { return tooth_force / scales.operation.load; }

  /// [N/m]: c[-] = c[m/N] p_h R_x*.
  double compliance_scale() const { return scales.pressure * scales.solids.radius_x; }
};

}  // namespace gearfilm
