// A gear pair marched in time, on its films, and watched step by step.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gearfilm/results.hpp"

namespace gearfilm {

/// One contact in a step.
class ContactInStep {
public:
  int number() const;       ///< number of the tooth pair: 0 for the leading one at the start, then counted on
  double position() const;  ///< xi on the line of action, from the pitch point [m]
  /// The value of a column of /history/contacts (docs/results.md) in SI: h_min, p_max, force, ... Throws
  /// std::out_of_range for a column that this case does not have.
  double value(const std::string& name) const;
  bool has_film() const;  ///< false in the dry model
  /// The film of the contact, valid only while the observer is called.
  Film film() const;

  struct View;
  explicit ContactInStep(std::shared_ptr<const View> view) : view_(std::move(view)) {}

private:
  std::shared_ptr<const View> view_;
};

/// An accepted time step, or a state from which steps start: length 0.
struct Step {
  double time = 0.0;    ///< time at the end of the step [s]
  double length = 0.0;  ///< its length [s]
  double H0 = 0.0;      ///< rigid displacement [-]
  double V0 = 0.0;      ///< velocity of the displacement, dH0/dT [-]
  std::vector<ContactInStep> contacts;

  /// Force on all contacts together [N].
  double total_force() const;
};

/// An observer is called on all processes after every step, and with every state from which steps start. It is called
/// first while a Simulation is made. An exception must be thrown on all processes alike.
using Observer = std::function<void(const Step&)>;

class Simulation {
public:
  /// Finds the stationary films from which the march starts, at rest or with the motion that the case gives. Throws
  /// InputError for a case that cannot be marched, and SolveError. Collective, as are all other members.
  Simulation(MPI_Comm comm, const Case& of, Observer observer = {});
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Marches on to a time, in mesh periods from the start; may be called again with a later one. Throws SolveError.
  void run_to(double mesh_periods);
  /// The present time [s].
  double time() const;
  /// The results of `gearfilm transient`: quantities of every mesh period, extremes, events, losses of contact.
  Results results() const;

private:
  struct March;
  std::unique_ptr<March> march_;
};

}  // namespace gearfilm
