// A gear pair on the films of its present contacts: a film system (film_system.hpp) whose bodies are the gears, alone
// or in their drive train, and whose contacts travel.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "dynamics/frequency_fit.hpp"
#include "dynamics/friction_force.hpp"
#include "mesh/dry_force.hpp"
#include "solver/film_system.hpp"

namespace gearfilm {

class LubricatedPair {
public:
  /// At least one contact, all with films of one discretisation, which must outlive the pair, as must the mesh. share:
  /// f along the path where the first contact travels.
  LubricatedPair(const MeshModel& mesh, const std::vector<ActiveContact>& contacts,
                 const std::optional<LoadSharing::Piece>& share = {});

  FilmSystem& system() { return system_; }
  const FilmSystem& system() const { return system_; }
  const MeshModel& mesh() const { return mesh_; }
  /// Numbers of the contacts.
  const std::vector<int>& numbers() const { return numbers_; }

  Motion motion(Vec state) const;
  void set_motion(Vec state, const Motion& motion) const;
  /// Errors over these, root mean square over all entries of a state, come to 1 where H_0, or V_0 times half a free
  /// oscillation, or the root mean square of the pressures is off by what is allowed.
  OwnedVec allowed_errors(double of_motion, double of_pressures) const;
  /// Without inertia: a guess of the state at T1 from that at T0, sunk as a Hertz contact sinks under its changed
  /// share.
  void predict_for_load_share(Vec state, double T0, double T1) const;
  /// With inertia: a guess of the motion at T1 from that at T0, of the same V_0, sunk by half of the thinnest film at
  /// most. quantities: of the films at T0.
  void predict_without_force(Vec state, double T0, double T1, const std::vector<FilmQuantities>& quantities) const;

  /// Where the flanks of a guess at T1 have parted since the last state, at T0, so far that ellipses draw back by much
  /// of a cell: pressures of the guess as those of Hertz contacts that shrink so. quantities: of the films of the last
  /// state.
  void predict_for_motion(Vec guess, Vec last, double T0, double T1,
                          const std::vector<FilmQuantities>& quantities) const;

  /// How the bodies would swing on dry contacts of these forces at T; at no rate without inertia.
  Swings swings(double T, const std::vector<FilmQuantities>& quantities) const;
  /// Sets the difference formula of the motion in the stage to come, and fits it to these swings.
  void step_motion(const Swings& swings, const std::function<FrequencyFit(double w)>& fit_of, OwnRates rates) {
    swings_ = swings;
    fit_ = ModalFit(swings, fit_of);
    rates_ = std::move(rates);
  }

  /// Without inertia: the contacts, which carry `load` [-] at T0, come to carry the static force at T1.
  void transfer_load(double T0, double T1, double load);

  /// Puts every contact where it is at time T.
  void place(double T);
  /// The rest before the contacts in time steps; together with them where there is no inertia, or no time step, or
  /// light nodes of a drive train are held by the contacts.
  void linearise(Vec state, const FilmSystem::Rate& rate, double shift,
                 SmootherFactors factors = SmootherFactors::of_this_state);

  /// What friction does to the motion in the time step to come: from the contacts of a step that begins or continues a
  /// segment. Where friction acts on it.
  void begin_friction(double T, const std::vector<ContactRecord>& contacts);
  void continue_friction(double T, const std::vector<ContactRecord>& contacts);

  /// Quantities of the film of every contact, placed at T. Collective.
  std::vector<FilmQuantities> film_quantities(Vec state, double T);
  /// Lets what follows the films follow them over a step of dT, at whose end film_quantities() has put them.
  /// Collective.
  void advance_processes(double dT);
  /// The records of all contacts at time T, after film_quantities() at that time, whose result `quantities` is.
  /// Collective.
  std::vector<ContactRecord> records(double T, const std::vector<FilmQuantities>& quantities) const;

private:
  /// Stiffness of the dry contacts under these forces at T [-].
  double contact_stiffness(double T, const std::vector<FilmQuantities>& quantities) const;
  BodyEquations bodies_at(double T) const;
  /// None without a backlash.
  ReverseFlankForce reverse_flanks_at(double T, const BodyEquations& bodies) const;
  /// f at time T; 1 where contacts share by themselves.
  double share_at(double T) const;
  /// What the contacts have not taken over yet of the static force at time T [-].
  double left_over(double T) const;

  const MeshModel& mesh_;
  std::vector<ActiveContact> contacts_;  ///< without fields
  std::vector<int> numbers_;
  std::vector<ContactFilm*> films_;
  std::optional<LoadSharing::Piece> share_;
  DryForce dry_force_;
  ExtrapolatedFriction friction_;
  Swings swings_;
  ModalFit fit_;
  OwnRates rates_;
  struct Transfer {
    double begin = 0.0;
    double end = 0.0;
    double left_over = 0.0;  ///< at the beginning [-]
  } transfer_;
  FilmSystem system_;
};

}  // namespace gearfilm
