// What one time step of a gear pair leaves behind.
#pragma once

#include <functional>
#include <vector>

#include "dynamics/active_contact.hpp"
#include "dynamics/contact_quantities.hpp"
#include "mesh/mesh_model.hpp"
#include "mesh/motion.hpp"

namespace gearfilm {

struct ContactRecord {
  int number = 0;       ///< of the tooth pair, counted from the leading one at T = 0
  double position = 0;  ///< xi [m]
  ContactQuantities quantities;
};

/// The record of a dry contact that gave these quantities at time T.
ContactRecord contact_record(const MeshModel& mesh, int number, double T, const FilmQuantities& quantities);

/// The records of contacts at time T, with the quantities of their films at the present state [-]. Collective.
std::vector<ContactRecord> contact_records(const MeshModel& mesh, const std::vector<ActiveContact>& contacts, double T,
                                           const std::vector<FilmQuantities>& quantities);

struct StepRecord {
  double T = 0.0;   ///< end of the step
  double dT = 0.0;  ///< its length; 0 for a starting state
  Motion motion;
  std::vector<ContactRecord> contacts;
  double back_force = 0.0;  ///< of reverse flanks [-]
  int halvings = 0;         ///< of it, for it could not be made whole
  int newton = 0;
  int krylov = 0;
  double wall_seconds = 0.0;
  bool replayed = false;  ///< computed by an earlier program (run_store.hpp): its films are not at hand

  double pressure_integral() const { return sum_of("force"); }
  /// Part of it that asperities carry; none where nothing is carried.
  double asperity_load_share() const {
    const double carried = pressure_integral();
    return carried > 0.0 ? sum_of("asperity_force") / carried : 0.0;
  }
  /// Lost by sliding and by rolling [W].
  double power_sliding() const { return sum_of("power_sliding"); }
  double power_rolling() const { return sum_of("power_rolling"); }

private:
  double sum_of(ContactQuantityName quantity) const {
    double sum = 0.0;
    for (const ContactRecord& contact : contacts) sum += contact.quantities[quantity];
    return sum;
  }
};

/// Receives every accepted step, and the state after every entering, leaving or jump (dT = 0 there).
using StepObserver = std::function<void(const StepRecord&, const std::vector<ActiveContact>&)>;
inline void unseen(const StepRecord&, const std::vector<ActiveContact>&) {}

}  // namespace gearfilm
