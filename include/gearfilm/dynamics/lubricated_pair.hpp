// The films of all present contacts and the motion of the gear pair as one implicit system.
//
//   G_k(P_k, H_0; d(rho H)_k/dT) = 0              every contact k: Reynolds' equation with cavitation, contact_film.hpp
//   dH_0/dT - V_0 = 0
//   I_n dV_0/dT - sum_k Int Int P_k dX dY + F* = 0                     (25) of doi 10.1016/j.triboint.2013.01.017
//
// With a prescribed share f of the static force in place of other contacts (prescribed_load.hpp), Int P counts 1/f
// times, and without inertia, I_n = 0, the last row is the quasi-static balance.
//
// State: [P_1, ..., P_n, H_0, V_0], the two scalars on the first process. The squeeze term differentiates rho H, not
// P: the time scheme is given C(state) = [(rho H)_1, ..., (rho H)_n, H_0, V_0] to difference, so mass is conserved.
// Preconditioner: one multigrid cycle a contact, and the motion before it (in time steps: a contact's stiffness is 1e-4
// of I_n/dT^2) or eliminated exactly (where the shift is small, as in an eigenvalue problem).
#pragma once

#include <optional>
#include <vector>

#include "gearfilm/dynamics/contact_path.hpp"
#include "gearfilm/dynamics/step_record.hpp"
#include "gearfilm/ehl/integral.hpp"
#include "gearfilm/ehl/newton.hpp"
#include "gearfilm/ehl/worst_node.hpp"
#include "gearfilm/gear/load_sharing.hpp"

namespace gearfilm {

/// A contact in the system: its number and its film.
struct PairContact {
  int contact = 0;
  ContactFilm* film = nullptr;
};

class LubricatedPair final : public LinearisedSystem {
public:
  /// At least one contact; all films on grids of one size. inertia I_n; share: f along the path where the first
  /// contact travels.
  LubricatedPair(const ContactPath& path, std::vector<PairContact> contacts, double inertia, const Scales& scales,
                 const std::optional<LoadSharing::Piece>& share = {});

  const std::vector<PairContact>& contacts() const { return contacts_; }
  OwnedVec create_state() const;
  /// The compact field of one contact (its pressure, or d(rho H)/dT in a rate), and the motion, out of or into a state.
  void set_field(Vec state, std::size_t contact, const std::vector<double>& field) const;
  std::vector<double> field(Vec state, std::size_t contact) const;
  void set_motion(Vec state, const Motion& motion) const;
  Motion motion(Vec state) const;
  /// Makes every pressure of a guess at least half of what it is in the last state, and >= 0.
  void restrain(Vec guess, Vec last) const;
  /// Without inertia: a guess of the state at T1 from that at T0, sunk as a Hertz contact sinks under its changed
  /// share.
  void follow_share(Vec state, double T0, double T1) const;

  /// Puts every contact where it is at time T.
  void place(double T);

  /// Rows of the system at the present place; rate = d C(state)/dT, about shift times a change of C. Scaled so that
  /// norm/sqrt(nodes) is a root mean square over the films plus the relative errors of the motion.
  void residual(Vec state, Vec rate, double shift, Vec rows);
  /// C(state).
  void storage(Vec state, Vec stored);
  enum class Elimination { motion_first, exact };
  /// Prepares multiply() and precondition() at the state of the last residual(), for d(rate)/d(C) = shift.
  void linearise(double shift, Elimination elimination = Elimination::motion_first);
  void multiply(Vec change, Vec rows) override;
  /// The part of multiply() that grows with the shift.
  void multiply_storage(Vec change, Vec rows);
  void precondition(Vec rows, Vec change) override;

  /// Figures of every contact at the last state.
  std::vector<ContactRecord> records(double T) const;
  /// Where the rows of one contact are largest. Collective.
  WorstNode worst_node(Vec rows, std::size_t contact) const;
  /// sqrt(nodes of all films): the weight of the motion's rows.
  double weight() const { return weight_; }
  PetscInt local_size() const override { return pressure_count() + (has_motion() ? 2 : 0); }
  PetscInt pressure_count() const override { return static_cast<PetscInt>(motion_at()); }
  MPI_Comm comm() const override { return grid_.comm(); }

private:
  std::size_t field_size() const { return static_cast<std::size_t>(grid_.local_size()); }
  /// First entry of the motion in a local array.
  std::size_t motion_at() const { return contacts_.size() * field_size(); }
  bool has_motion() const { return grid_.rank() == 0; }
  Motion broadcast(const double* values) const;
  /// The residuals of the motion's rows without their scales.
  Motion unweighted(const Motion& rows) const;
  void precondition_motion_first(Vec rows, Vec change);
  void precondition_exactly(Vec rows, Vec change);
  /// Int Int of the pressures, or their changes, of all contacts together.
  double carried_by(const double* fields) const { return integral(grid_, fields, motion_at()); }

  const ContactPath& path_;
  std::vector<PairContact> contacts_;
  const Grid& grid_;
  double inertia_;
  double static_force_;
  double approach_;  ///< of a Hertz contact under the static force
  std::optional<LoadSharing::Piece> sharing_;
  double share_ = 1.0;  ///< f at the present place
  double weight_;
  double shift_ = 0.0;
  Elimination elimination_ = Elimination::motion_first;
  std::vector<double> column_solution_;  ///< (dG_k/dP_k)^-1 dG_k/dH_0 of all contacts, approximately
  double stiffness_ = 0.0;               ///< its integral over f, -d(F/f)/dH_0; zero with the motion first
  std::vector<double> work_;
};

}  // namespace gearfilm
