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
  int number() const;       ///< of the tooth pair, 0 for the leading one at the start
  double position() const;  ///< xi on the line of action, from the pitch point [m]
  /// A column of /history/contacts (docs/results.md) in SI: h_min, p_max, force, ... Throws std::out_of_range for
  /// what this case does not have.
  double value(const std::string& name) const;
  bool has_film() const;  ///< not in the dry model
  /// Its film; valid while the observer is called.
  Film film() const;

  struct View;
  explicit ContactInStep(std::shared_ptr<const View> view) : view_(std::move(view)) {}

private:
  std::shared_ptr<const View> view_;
};

/// An accepted time step, or a state from which steps start: length 0.
struct Step {
  double time = 0.0;    ///< at its end [s]
  double length = 0.0;  ///< [s]
  double H0 = 0.0;      ///< rigid displacement [-]
  double V0 = 0.0;      ///< its velocity dH0/dT [-]
  std::vector<ContactInStep> contacts;

  /// Force on all contacts together [N].
  double total_force() const;
};

/// Called on all processes after every step, and for the states from which steps start: the first of them while a
/// Simulation is made. What it throws it must throw on all processes.
using Observer = std::function<void(const Step&)>;

class Simulation {
public:
  /// From stationary films, at rest or with the motion that the case starts with. Throws InputError for a case that
  /// cannot be marched, and SolveError. Collective, as are the others.
  Simulation(MPI_Comm comm, const Case& of, Observer observer = {});
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Marches on to a time, in mesh periods from the start; may be called again with a later one. Throws SolveError.
  void run_to(double mesh_periods);
  /// The present time [s].
  double time() const;
  /// Those of `gearfilm transient`: quantities of every mesh period, extremes, events, losses of contact.
  Results results() const;

private:
  struct March;
  std::unique_ptr<March> march_;
};

}  // namespace gearfilm
