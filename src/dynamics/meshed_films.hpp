// The films of the contacts that a pair has at one time: they enter, rest, follow jumps, and have room on their grid.
//
// A contact enters as a stationary film at the present H_0 beside the contacts that are there, on the spring of its own
// teeth. Jumps of H_0, and of the forces that bend other contacts' teeth, are taken within one time step.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "dynamics/entering_film.hpp"
#include "dynamics/pair_state.hpp"
#include "dynamics/segment_stepper.hpp"
#include "film/domain_margins.hpp"

namespace gearfilm {

/// Told of the shape that a grid is about to be given; may throw SolveError. Collective.
using WideningObserver = std::function<void(MPI_Comm, const GridShape&)>;

struct MarchOptions {
  SolverOptions films;  ///< of the films' own solvers
  StepOptions steps;
  std::optional<MarginRule> margins{};  ///< by which the grid is widened; none: it stays as it is
  WideningObserver on_widening{};
};

class MeshedFilms {
public:
  /// All contacts have films of this discretisation, at first.
  MeshedFilms(SharedDiscretisation discretisation, MeshModel mesh, MarchOptions options);

  /// The contacts at T = 0: at the given motion, or at rest where they carry the static force.
  void start(const std::optional<Motion>& motion);
  /// Lets contacts leave and enter that do so now; false where there are none.
  bool exchange();
  /// Takes films along to another motion, within a time, or a step where that is longer.
  void displace(const Motion& motion, double duration);
  /// Takes up a state, with films of these contacts, on a grid that holds both its own and the present one.
  void take_up(double T, const PairState& state, const std::vector<int>& numbers);
  /// What a march has come to: time and motion, and the fields of a contact.
  void move(double T, const Motion& motion) {
    T_ = T;
    motion_ = motion;
  }
  void set_fields(std::size_t contact, std::vector<double> pressure, std::vector<double> rate);
  /// Makes the rates those of the present pressures in the flow that heat has made since, where films feel it.
  void adapt_rates();
  /// Makes the pressures those of the present rates: films of another grid, interpolated, may be off by more than they
  /// are thick. Throws SolveError where there are none.
  void adapt_pressures();

  double T() const { return T_; }
  const Motion& motion() const { return motion_; }
  const MeshModel& mesh() const { return mesh_; }
  const MarchOptions& options() const { return options_; }
  const SharedDiscretisation& discretisation() const { return discretisation_; }
  /// The leading one first.
  const std::vector<ActiveContact>& contacts() const { return contacts_; }
  /// What the next contact to enter begins with, if it is near.
  EnteringFilm& entering() { return entering_; }
  const EnteringFilm& entering() const { return entering_; }
  PairState state() const;
  /// Pressure integrals of the contacts [-].
  std::vector<double> forces() const;
  std::vector<ContactRecord> records() const;
  /// A contact and where it is, for messages.
  std::string label(int number) const;

  /// What a contact needs under this pressure integral; nothing where the grid stays as it is.
  DomainMargins required_margins(int number, double pressure_integral) const;
  bool fits(const DomainMargins& needed) const { return gearfilm::fits(discretisation_->grid().shape(), needed); }
  /// Widens the grid where the present contacts lack room; says whether it did.
  bool grow_domain();

private:
  MPI_Comm comm() const { return discretisation_->grid().comm(); }
  std::vector<int> numbers() const { return numbers_of(contacts_); }
  /// H_k.
  std::vector<double> displacements() const;
  std::map<int, double> displacement_by_number() const;
  /// Put where they are now.
  std::vector<ContactFilm*> present_films() const;
  std::vector<FilmQuantities> quantities() const;
  /// A field of all contacts, one after the other.
  std::vector<double> values(const ContactField& kind) const;
  void set_values(const ContactField& kind, std::span<const double> values);
  /// rho H of all films at these displacements.
  std::vector<double> oil_at(const std::vector<double>& displacements) const;

  /// The present pressures, changed as those of dry contacts by the way from these displacements to those of now.
  std::vector<double> rescaled_pressures(const std::vector<double>& displaced) const;

  /// A new contact, among those together with it, of which the first ones carry these forces.
  ActiveContact enter(int number, const std::vector<int>& together, std::vector<double> carried);
  void balance_at_rest();
  /// Makes each film stationary beneath the forces of the others, until these no longer change.
  void follow_neighbours(const Compliance& compliance);
  /// Makes the present films stationary together.
  void settle(const LoadCondition& load);
  /// Takes the present films within a time to the present motion from where they were displaced before, by number.
  void follow(const std::map<int, double>& before, double duration);

  ContactFilm* free_film();
  /// Puts the present contacts and their fields on a grid of another shape.
  void move_to(const GridShape& shape);
  bool grow_domain(const DomainMargins& needed);

  SharedDiscretisation discretisation_;
  MeshModel mesh_;
  MarchOptions options_;
  std::vector<std::unique_ptr<ContactFilm>> films_;  ///< in use or waiting for the next contact
  std::vector<ActiveContact> contacts_;
  double T_ = 0.0;
  Motion motion_;
  EnteringFilm entering_;
};

}  // namespace gearfilm
