#include "dynamics/lubricated_pair.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/train_equations.hpp"
#include "film/face_pressure.hpp"
#include "film/rescaled_hertz_pressure.hpp"
#include "mesh/reverse_flanks.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<double> smallest_ratio("guess_smallest_ratio", 0.1,
                                   "ratio of half-axes of a contact in a step, at least, for guesses to be scaled");
const Tuned<double> crossed("guess_crossed", 0.5, "part of a central film that the motion of a guess may cross");
const Tuned<double> receded("guess_receded", 0.3, "mesh widths by which the ends of the ellipse may recede in a step");

std::vector<ContactFilm*> films_of(const std::vector<ActiveContact>& contacts) {
  std::vector<ContactFilm*> films(contacts.size());
  std::ranges::transform(contacts, films.begin(), &ActiveContact::film);
  return films;
}

/// Of so many degrees of freedom without inertia.
Swings resting(Eigen::Index freedoms) {
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(freedoms, freedoms);
  return {Eigen::VectorXd::Zero(freedoms), unit, unit};
}

std::vector<ActiveContact> without_fields(const std::vector<ActiveContact>& contacts) {
  std::vector<ActiveContact> bare = contacts;
  for (ActiveContact& contact : bare) contact.fields = {};
  return bare;
}

}  // namespace

LubricatedPair::LubricatedPair(const MeshModel& mesh, const std::vector<ActiveContact>& contacts,
                               const std::optional<LoadSharing::Piece>& share)
    : mesh_(mesh),
      contacts_(without_fields(contacts)),
      numbers_(numbers_of(contacts)),
      films_(films_of(contacts)),
      share_(share),
      dry_force_(mesh),
      friction_(mesh.freedoms()),
      swings_(resting(mesh.freedoms())),
      fit_(swings_, [](double) { return FrequencyFit(); }),
      system_(films_, bodies_at(0.0)) {}

Motion LubricatedPair::motion(Vec state) const { return motion_from(system_.scalars(state)); }

void LubricatedPair::set_motion(Vec state, const Motion& motion) const {
  const Eigen::VectorXd scalars = to_vector(motion);
  system_.set_scalars(state, {scalars.data(), static_cast<std::size_t>(scalars.size())});
}

OwnedVec LubricatedPair::allowed_errors(double of_motion, double of_pressures) const {
  OwnedVec errors = system_.create_state();
  PetscInt entries = 0;
  petsc_check(VecSet(errors, of_pressures));
  petsc_check(VecGetSize(errors, &entries));
  const double alone = of_motion / std::sqrt(static_cast<double>(entries));
  // Without inertia V_0 is no more than a difference of H_0.
  const double of_velocity = mesh_.inertia > 0.0 ? alone / mesh_.velocity_weight() : HUGE_VAL;
  const Eigen::Index n = mesh_.freedoms();
  set_motion(errors, {Eigen::VectorXd::Constant(n, alone), Eigen::VectorXd::Constant(n, of_velocity)});
  return errors;
}

double LubricatedPair::share_at(double T) const {
  return share_ ? (*share_)(mesh_.path.position(numbers_.front(), T)) : 1.0;
}

void LubricatedPair::predict_for_load_share(Vec state, double T0, double T1) const {
  if (mesh_.inertia > 0.0 || !share_) return;
  const auto approach_at = [&](double T) {
    const double share = share_at(T), compliance = mesh_.compliance(numbers_, T)(0, 0);
    const FaceLaw* face = mesh_.scales.face_law.get();
    const double force = share * mesh_.scales.static_force;
    const double contact = face ? face->approach(force, 1.0) : mesh_.scales.approach * std::cbrt(share * share);
    return contact + compliance * force;
  };
  const double sinking = approach_at(T1) - approach_at(T0);
  set_motion(state, {motion(state).H0() - sinking, -sinking / (T1 - T0)});
}

// The pressures of the guess are still those from before: bodies that sink by more than a film would touch.
void LubricatedPair::predict_without_force(Vec state, double T0, double T1,
                                           const std::vector<FilmQuantities>& quantities) const {
  if (mesh_.inertia == 0.0) return;
  const Motion last = motion(state);
  double thinnest = HUGE_VAL;
  for (const FilmQuantities& film : quantities) thinnest = std::min(thinnest, film.central_film);
  const double change = std::max((T1 - T0) * last.V0(), -crossed * thinnest);
  Motion guess = moved(last, T1 - T0, {last.v, Eigen::VectorXd::Zero(last.freedoms())});
  guess.H0() = last.H0() + change;
  set_motion(state, guess);
}

// An extrapolation of pressures at their nodes would leave gaps and overlaps many films deep where a contact shrinks by
// a node or more in a step. Where it grows, the extrapolated pressures are the better guess.
void LubricatedPair::predict_for_motion(Vec guess, Vec last, double T0, double T1,
                                        const std::vector<FilmQuantities>& quantities) const {
  const Eigen::VectorXd displaced = system_.displacements(last);
  std::vector<double> before, at;  // forces, and displacements with the gaps of T1
  for (std::size_t k = 0; k < films_.size(); ++k) {
    before.push_back(std::max(0.0, quantities[k].pressure_integral));
    const auto gap_at = [&](double T) { return mesh_.contact(numbers_[k], T).conditions.dry_gap(); };
    at.push_back(displaced[static_cast<Eigen::Index>(k)] - (gap_at(T1) - gap_at(T0)));
  }
  DryContacts dry(dry_force_, mesh_, numbers_, T1);
  dry.stand_for(before, at);
  const std::vector<double> after = dry.forces(motion(guess).H0());
  struct Shrinking {
    std::size_t contact;
    ContactConditions conditions;
    HertzContact before;
    double force, ratio;  ///< to which it shrinks, and its half-axes' ratio
  };
  std::vector<Shrinking> shrinking;
  bool recede = false;
  for (std::size_t k = 0; k < films_.size(); ++k) {
    if (before[k] <= 0.0 || after[k] >= before[k]) continue;
    const ContactConditions conditions = mesh_.contact(numbers_[k], T0).conditions;
    const HertzContact contact = dry_contact(mesh_.scales, conditions, before[k]);
    const double force = std::max(std::pow(smallest_ratio, 3) * before[k], after[k]);
    const double ratio = dry_contact(mesh_.scales, conditions, force).a / contact.a;
    shrinking.push_back({k, conditions, contact, force, ratio});
    recede = recede || (1.0 - ratio) * contact.a >= receded * films_[k]->grid().h_x() * mesh_.scales.length;
  }
  if (!recede) return;
  // All of them, since on teeth that bend one film's force displaces the others.
  for (const auto& [k, conditions, contact, force, ratio] : shrinking) {
    const std::vector<double> pressure = system_.field(last, k);
    system_.set_field(
        guess, k,
        mesh_.scales.face_law
            ? rescaled_face_pressure(*films_[k]->discretisation(), mesh_.scales, conditions, before[k], force, pressure)
            : rescaled_hertz_pressure(films_[k]->grid(), mesh_.scales, contact, ratio, pressure, conditions.nearest.X));
  }
}

double LubricatedPair::contact_stiffness(double T, const std::vector<FilmQuantities>& quantities) const {
  std::vector<double> forces(quantities.size());
  std::ranges::transform(quantities, forces.begin(),
                         [](const FilmQuantities& film) { return std::max(0.0, film.pressure_integral); });
  return DryContacts(dry_force_, mesh_, numbers_, T).stiffness(forces) / share_at(T);
}

Swings LubricatedPair::swings(double T, const std::vector<FilmQuantities>& quantities) const {
  if (mesh_.inertia == 0.0) return resting(1);
  const double stiffness = contact_stiffness(T, quantities);
  if (mesh_.train) return swings_of(*mesh_.train, stiffness);
  Swings swings = resting(1);
  swings.rates[0] = std::sqrt(stiffness / mesh_.inertia);
  return swings;
}

void LubricatedPair::transfer_load(double T0, double T1, double load) {
  transfer_ = {T0, T1, mesh_.scales.static_force - load};
}

double LubricatedPair::left_over(double T) const {
  if (T >= transfer_.end) return 0.0;
  return transfer_.left_over * (transfer_.end - T) / (transfer_.end - transfer_.begin);
}

void LubricatedPair::place(double T) {
  for (std::size_t k = 0; k < films_.size(); ++k) {
    ContactConditions conditions = mesh_.contact(numbers_[k], T).conditions;
    conditions.texture.moves = true;
    move_surfaces(*films_[k], conditions);
  }
  BodyEquations bodies = with_rates(fitted(bodies_at(T), fit_), rates_);
  ReverseFlankForce reverse_flanks = reverse_flanks_at(T, bodies);
  system_.set_bodies(std::move(bodies), mesh_.compliance(numbers_, T), std::move(reverse_flanks));
}

BodyEquations LubricatedPair::bodies_at(double T) const {
  const double force = mesh_.scales.static_force;
  if (mesh_.train) {
    return equation_of_motion(*mesh_.train,
                              {force, share_at(T), friction_.at(T), mesh_.train->torque_acceleration(mesh_.path, T)},
                              films_.size());
  }
  return equation_of_motion({mesh_.inertia, force, share_at(T), friction_.at(T)[0] - left_over(T)}, films_.size());
}

ReverseFlankForce LubricatedPair::reverse_flanks_at(double T, const BodyEquations& bodies) const {
  if (!mesh_.teeth.backlash()) return {};
  const auto law = [this, T](double approach) {
    const ReverseForce back = reverse_flank_force(mesh_, approach, T);
    return ReverseFlankForce::Value{back.value, back.slope};
  };
  if (mesh_.train) return reverse_flanks_in(*mesh_.train, mesh_.scales.static_force, law);
  // They approach as H_0 grows, and act along the line on which the films act.
  return {law, bodies.displacement.row(0), bodies.force.col(0)};
}

void LubricatedPair::begin_friction(double T, const std::vector<ContactRecord>& contacts) {
  if (mesh_.friction_couples_dynamics) friction_.begin(T, friction_on_motion(mesh_, contacts));
}

void LubricatedPair::continue_friction(double T, const std::vector<ContactRecord>& contacts) {
  if (mesh_.friction_couples_dynamics) friction_.add(T, friction_on_motion(mesh_, contacts));
}

void LubricatedPair::linearise(Vec state, const FilmSystem::Rate& rate, double shift, SmootherFactors factors) {
  const bool together = mesh_.inertia == 0.0 || shift == 0.0 || (mesh_.train && contacts_hold(swings_, shift));
  system_.linearise(state, rate, shift,
                    together ? FilmSystem::BlockElimination::exact : FilmSystem::BlockElimination::scalars_first,
                    factors);
}

std::vector<FilmQuantities> LubricatedPair::film_quantities(Vec state, double T) {
  place(T);
  return system_.quantities(state);
}

void LubricatedPair::advance_processes(double dT) {
  for (const ActiveContact& contact : contacts_) {
    for (const auto& process : contact.processes) process->advance(*contact.film, dT);
  }
}

std::vector<ContactRecord> LubricatedPair::records(double T, const std::vector<FilmQuantities>& quantities) const {
  return contact_records(mesh_, contacts_, T, quantities);
}

}  // namespace gearfilm
