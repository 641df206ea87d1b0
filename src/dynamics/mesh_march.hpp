// The lubricated gear pair marched in time through its mesh cycle.
//
// Between events (a contact enters or leaves) a SegmentStepper integrates; at an entry the new contact's film starts as
// the stationary film at the present H_0; at an exit the old film is dropped.
// Where one contact bends another's teeth, films follow the change as they follow a jump of H_0. Without inertia the
// load passes in a straight line to the contacts that an event leaves, and steps become longer once it has died away.
// Source: Figs. 5 and 6 of doi 10.1016/j.triboint.2013.01.017.
#pragma once

#include <optional>

#include "dynamics/meshed_films.hpp"
#include "dynamics/run_store.hpp"

namespace gearfilm {

/// Time in which, without inertia, the load passes to the contacts that are there after an event, over a mesh period.
constexpr double part_of_transfer = 1.0 / 100.0;

/// Multigrid levels that serve time steps best, by measurement: 1, the smoother alone, on grids of up to 10000 nodes,
/// and up to 50000 where a step is no longer than a few mesh widths, so that squeezing makes the operator well
/// conditioned: it takes more Krylov iterations, but cheap ones; 0, all levels, beyond. Where cells are long
/// (grid/grid) and a step is no longer than 1.5 mesh widths, 1 on grids of any size: levels with half the rows diverge
/// there.
int step_levels(const Grid& grid, double dT);

class MeshMarch {
public:
  /// All contacts have films of this discretisation, at first. With a prescribed load the mesh has a single contact. A
  /// store must outlive the march.
  MeshMarch(SharedDiscretisation discretisation, MeshModel mesh, MarchOptions options, StepObserver observer,
            RunStore* store = nullptr);

  /// Stationary films of all contacts at T = 0: at the given motion, or at rest where they carry the static force.
  void start(const std::optional<Motion>& motion);
  /// Integrates up to T_end: one run, of which a store may know a part.
  void run(double T_end);

  /// The present state.
  PairState state() const { return films_.state(); }
  /// Goes on from a state at time T, with one film for each contact that exists just after it, on a grid that holds
  /// both the state's and the present one: they must have the same lattice.
  void resume(double T, const PairState& state);
  /// Jumps to another motion. The films follow as they would if the jump took this long, and at least a time step: oil
  /// that cannot flow away in it stays.
  void displace(const Motion& motion, double duration = 0.0);
  /// What this process remembers for first guesses. remember() gives it to a march over the same steps that goes on
  /// from here on as many processes; a march without it guesses as if it had just begun.
  std::vector<double> memory() const;
  void remember(std::span<const double> memory);
  /// Newton's tolerance of the steps from here on, in that of the options.
  void set_looseness(double looseness) { looseness_ = looseness; }
  /// Makes films of another grid those of this one, with the rates that they have. Throws SolveError.
  void adapt_pressures() { films_.adapt_pressures(); }

  /// The contacts that exist now, the leading one first.
  const std::vector<ActiveContact>& contacts() const { return films_.contacts(); }

  const MeshModel& mesh() const { return films_.mesh(); }
  double T() const { return films_.T(); }
  const Motion& motion() const { return films_.motion(); }
  /// The discretisation of the present films.
  const SharedDiscretisation& discretisation() const { return films_.discretisation(); }
  /// Steps so far that had to be halved.
  int halved_steps() const { return halved_steps_; }
  MPI_Comm comm() const { return discretisation()->grid().comm(); }

private:
  void exchange_contacts();
  void show(const StepRecord& record, const std::vector<ActiveContact>& contacts);
  void observe(const StepRecord& record);
  void observe_present();
  /// transferred: when the load has passed to the present contacts, where it does.
  void run_segment(double T_end, const StepOptions& steps, const std::optional<LoadSharing::Piece>& share,
                   std::optional<double> transferred);

  MeshedFilms films_;
  StepObserver observer_;
  RunStore* store_;
  PeriodicPredictor guesses_;
  int halved_steps_ = 0;
  double looseness_ = 1.0;
};

}  // namespace gearfilm
