// The lubricated gear pair marched in time through its mesh cycle.
//
// Between events (a contact enters or leaves) a SegmentStepper integrates; at an entry the new contact's film starts as
// the stationary film at the present H_0, reached from its neighbour's pressure; at an exit the old film is dropped.
// Where one contact bends another's teeth, films follow the change as they follow a jump of H_0.
// Source: Figs. 5 and 6 of doi 10.1016/j.triboint.2013.01.017.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "gearfilm/dynamics/march_keeper.hpp"
#include "gearfilm/dynamics/segment_stepper.hpp"
#include "gearfilm/ehl/room.hpp"
#include "gearfilm/ehl/stationary.hpp"

namespace gearfilm {

/// Multigrid levels that serve time steps best, by measurement: 1, the smoother alone, on grids of up to 10000 nodes,
/// and up to 50000 where a step is no longer than a few mesh widths, so that squeezing makes the operator well
/// conditioned: it takes more Krylov iterations, but cheap ones; 0, all levels, beyond.
int step_levels(const Grid& grid, double dT);

struct MarchOptions {
  SolverOptions films;  ///< of the films' own solvers
  StepOptions steps;
  std::optional<RoomRule> room{};  ///< by which the grid is widened; none: it stays as it is
  std::function<void(MPI_Comm, const GridShape&)> on_widening{};  ///< told before; may throw SolveError
};

class MeshMarch {
public:
  /// All contacts have films of this discretisation, at first. With a prescribed load the mesh has a single contact. A
  /// keeper must outlive the march.
  MeshMarch(SharedDiscretisation discretisation, MeshModel mesh, MarchOptions options, StepObserver observer,
            MarchKeeper* keeper = nullptr);

  /// Stationary films of all contacts at T = 0: at the given motion, or at rest where they carry the static force.
  void start(const std::optional<Motion>& motion);
  /// Integrates up to T_end: one run, of which a keeper may know a part.
  void run(double T_end);

  /// The present state.
  PairState state() const;
  /// Goes on from a state at time T, with one film for each contact that exists just after it, on a grid that holds
  /// both the state's and the present one: they must have the same lattice.
  void resume(double T, const PairState& state);
  /// Jumps to another motion. The films follow as they would if the jump took no longer than a time step: oil that
  /// cannot flow away in it stays.
  void displace(const Motion& motion);

  /// The contacts that exist now, the leading one first.
  const std::vector<LiveContact>& contacts() const { return contacts_; }

  const MeshModel& mesh() const { return mesh_; }
  double T() const { return T_; }
  const Motion& motion() const { return motion_; }
  /// Of the present films.
  const SharedDiscretisation& discretisation() const { return discretisation_; }
  MPI_Comm comm() const { return discretisation_->grid().comm(); }

private:
  std::vector<int> numbers() const;
  /// A film before a jump: H of its solids, and rho H.
  struct FilmInPlace {
    double displacement = 0.0;
    std::vector<double> oil;
  };
  // Of the present contacts: forces, displacements, films put where they are now, pressures one after the other.
  std::vector<double> forces() const;
  std::vector<double> displacements() const;
  std::vector<ContactFilm*> present_films() const;
  std::vector<double> pressures() const;
  void set_pressures(std::span<const double> pressures);
  /// By the contacts' numbers.
  std::map<int, FilmInPlace> films_in_place() const;
  /// A contact that enters at T_: its stationary film at the present H_0 beside the present contacts.
  LiveContact enter(int number);
  std::vector<double> entering_guess(const ContactFilm& film, const LoadCondition& load) const;
  void balance_at_rest();
  /// Makes the present films stationary together.
  void settle(const LoadCondition& load);
  /// Takes the present films within a time step to the present motion and contacts from where they were.
  void follow(const std::map<int, FilmInPlace>& before);
  void exchange_contacts();
  void observe(const StepRecord& record) const;
  /// At the fields and the motion of now.
  std::vector<FilmFigures> present_figures() const;
  void observe_present() const;
  ContactFilm* free_film();
  /// Puts the present contacts and their fields on a grid of another shape.
  void move_to(const GridShape& shape);
  /// What a contact needs under this pressure integral; nothing where the grid stays as it is.
  Room needed_room(int number, double pressure_integral) const;
  bool has_room(const Room& needed) const { return gearfilm::has_room(discretisation_->grid().shape(), needed); }
  /// Widens the grid where it lacks what is needed.
  void make_room(const Room& needed);
  /// For the present contacts.
  void make_room();
  /// resume() with these contacts.
  void take_up(double T, const PairState& state, const std::vector<int>& numbers);
  void run_segment(double T_end, const StepOptions& steps, const std::optional<LoadSharing::Piece>& share);
  std::string label(int number) const;

  SharedDiscretisation discretisation_;
  MeshModel mesh_;
  MarchOptions options_;
  StepObserver observer_;
  MarchKeeper* keeper_;
  std::vector<std::unique_ptr<ContactFilm>> films_;  ///< in use or waiting for the next contact
  std::vector<LiveContact> contacts_;
  double T_ = 0.0;
  Motion motion_;
};

}  // namespace gearfilm
