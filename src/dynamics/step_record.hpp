// What one time step of a gear pair leaves behind.
#pragma once

#include <functional>
#include <vector>

#include "dynamics/contact_figures.hpp"
#include "dynamics/live_contact.hpp"
#include "mesh/mesh_model.hpp"
#include "mesh/motion.hpp"

namespace gearfilm {

struct ContactRecord {
  int number = 0;       ///< of the tooth pair, counted from the leading one at T = 0
  double position = 0;  ///< xi [m]
  ContactFigures figures;
};

/// The record of a dry contact that gave these figures at time T.
ContactRecord contact_record(const MeshModel& mesh, int number, double T, const FilmFigures& figures);

/// The records of contacts at time T, with the figures of their films at the present state [-]. Collective.
std::vector<ContactRecord> contact_records(const MeshModel& mesh, const std::vector<LiveContact>& contacts, double T,
                                           const std::vector<FilmFigures>& figures);

struct StepRecord {
  double T = 0.0;   ///< end of the step
  double dT = 0.0;  ///< its length; 0 for a starting state
  Motion motion;
  std::vector<ContactRecord> contacts;
  double back_force = 0.0;  ///< of back flanks [-]
  int halvings = 0;         ///< of it, for it could not be made whole
  int newton = 0;
  int krylov = 0;
  double wall_seconds = 0.0;
  bool recalled = false;  ///< computed by an earlier program (march_keeper.hpp): its films are not at hand

  double pressure_integral() const { return sum_of("force"); }
  /// Lost by sliding and by rolling [W].
  double power_sliding() const { return sum_of("power_sliding"); }
  double power_rolling() const { return sum_of("power_rolling"); }

private:
  double sum_of(ContactFigureName figure) const {
    double sum = 0.0;
    for (const ContactRecord& contact : contacts) sum += contact.figures[figure];
    return sum;
  }
};

/// Receives every accepted step, and the state after every entering, leaving or jump (dT = 0 there).
using StepObserver = std::function<void(const StepRecord&, const std::vector<LiveContact>&)>;
inline void unseen(const StepRecord&, const std::vector<LiveContact>&) {}

}  // namespace gearfilm
