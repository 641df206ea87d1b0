#include "gearfilm/dynamics/mesh_march.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include "gearfilm/dynamics/back_flanks.hpp"
#include "gearfilm/dynamics/dry_force.hpp"
#include "gearfilm/ehl/integral.hpp"
#include "gearfilm/ehl/refit.hpp"
#include "gearfilm/ehl/validity.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/parallel/events.hpp"

namespace gearfilm {
namespace {

/// A stationary film.
ContactFields still(std::vector<double> pressure) {
  std::vector<double> rate(pressure.size(), 0.0);
  ContactFields fields;
  fields.emplace(field::pressure.name, std::move(pressure));
  fields.emplace(field::rate.name, std::move(rate));
  return fields;
}

}  // namespace

int step_levels(const Grid& grid, double dT) {
  const bool well_conditioned = dT <= 4.0 * grid.h_x();
  return grid.nx() * grid.ny() <= (well_conditioned ? 50000 : 10000) ? 1 : 0;
}

MeshMarch::MeshMarch(SharedDiscretisation discretisation, MeshModel mesh, MarchOptions options, StepObserver observer,
                     MarchKeeper* keeper)
    : discretisation_(std::move(discretisation)),
      mesh_(std::move(mesh)),
      options_(std::move(options)),
      observer_(std::move(observer)),
      keeper_(keeper) {}

std::string MeshMarch::label(int number) const {
  std::ostringstream text;
  text << "contact " << number << " at xi = " << 1e3 * mesh_.path.position(number, T_) << " mm (T = " << T_ << ")";
  return text.str();
}

ContactFilm* MeshMarch::free_film() {
  for (const auto& film : films_) {
    const auto uses = [&](const LiveContact& contact) { return contact.film == film.get(); };
    if (std::none_of(contacts_.begin(), contacts_.end(), uses)) return film.get();
  }
  films_.push_back(std::make_unique<ContactFilm>(discretisation_, mesh_.scales, options_.films.multigrid));
  return films_.back().get();
}

void MeshMarch::move_to(const GridShape& shape) {
  const SharedDiscretisation before = discretisation_;
  if (shape == before->grid().shape()) return;
  discretisation_ = discretise(Grid(comm(), shape), mesh_.scales);
  films_.clear();
  for (LiveContact& contact : contacts_) contact.film = nullptr;
  for (LiveContact& contact : contacts_) {
    contact.film = free_film();
    for (auto& [name, values] : contact.fields) values = refitted(values, before->grid(), discretisation_->grid());
  }
}

// The force grows with the power 3/2 of the approach, the half-axes with its root; where flanks have a local shape, the
// ellipse moves along the contact. Two steps ahead: in one the ellipse must not pass the edge.
Room MeshMarch::needed_room(int number, double pressure_integral) const {
  if (!options_.room || pressure_integral <= 0.0) return {};
  const ContactConditions conditions = mesh_.contact(number, T_).conditions;
  const double approach = dry_contact(mesh_.scales, conditions, pressure_integral).approach / mesh_.scales.thickness;
  const double sinking = std::max(0.0, -motion_.V0) * 2.0 * options_.steps.dT;
  const double growth = std::sqrt(1.0 + std::min(0.5, sinking / approach));
  const auto room_of = [&](const ContactConditions& in) {
    return gearfilm::needed_room(*options_.room, mesh_.scales, in, pressure_integral, label(number), growth);
  };
  const Room here = room_of(conditions);
  if (!conditions.local.flanks) return here;
  return united(here, room_of(mesh_.contact(number, T_ + 2.0 * options_.steps.dT).conditions));
}

void MeshMarch::make_room(const Room& needed) {
  if (has_room(needed)) return;
  const GridShape shape = widened(discretisation_->grid().shape(), needed, *options_.room);
  if (options_.on_widening) options_.on_widening(comm(), shape);
  move_to(shape);
}

void MeshMarch::make_room() {
  Room needed;
  if (!options_.room) return;
  const std::vector<double> carried = forces();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    needed = united(needed, needed_room(contacts_[k].number, carried[k]));
  }
  make_room(needed);
}

std::vector<int> MeshMarch::numbers() const {
  std::vector<int> numbers(contacts_.size());
  std::ranges::transform(contacts_, numbers.begin(), &LiveContact::number);
  return numbers;
}

std::vector<double> MeshMarch::forces() const {
  std::vector<double> forces;
  for (const LiveContact& contact : contacts_) {
    forces.push_back(integral(discretisation_->grid(), values_of(contact.fields, field::pressure)));
  }
  return forces;
}

std::vector<double> MeshMarch::displacements() const {
  return mesh_.compliance(numbers(), T_).displacements(motion_.H0, forces());
}

// Its neighbours bend its teeth; how it bends theirs, they learn of when all contacts that exist from now on are there.
LiveContact MeshMarch::enter(int number) {
  const ScopedStage stage("Entering film");
  for (;;) {
    std::vector<int> together = numbers();
    std::vector<double> carried = forces();
    together.push_back(number);
    carried.push_back(0.0);
    const Compliance compliance = mesh_.compliance(together, T_);
    const double displaced = compliance.displacements(motion_.H0, carried).back();
    const LoadCondition load = LoadCondition::displacement(displaced, compliance.alone(contacts_.size()));
    ContactFilm* film = free_film();
    film->set_conditions(mesh_.contact(number, T_).conditions);
    const StationaryResult entered = located(label(number) + ", entering", [&] {
      if (contacts_.empty()) return solve_stationary(*film, load, options_.films);
      return continue_stationary(*film, load, options_.films, {entering_guess(*film, load), displaced});
    });
    const Room needed = needed_room(number, entered.figures.pressure_integral);
    if (has_room(needed)) {
      check_validity(*film, entered.figures, label(number));
      return {number, film, still(entered.solution.pressure)};
    }
    make_room(needed);
  }
}

// The pressure of its neighbour, or none where the teeth are apart.
std::vector<double> MeshMarch::entering_guess(const ContactFilm& film, const LoadCondition& load) const {
  std::vector<double> pressure = values_of(contacts_.back().fields, field::pressure);
  if (load.value + film.conditions().dry_gap() >= 0.0) std::ranges::fill(pressure, 0.0);
  return pressure;
}

// Each film by itself as a dry contact's, then all of them together.
void MeshMarch::balance_at_rest() {
  const std::vector<int> numbers = mesh_.path.contacts_after(T_);
  contacts_.clear();
  // None of them carries more than the whole force.
  Room needed;
  for (int number : numbers) needed = united(needed, needed_room(number, mesh_.scales.static_force));
  make_room(needed);
  const auto sharing = mesh_.share_from(T_);
  const double share = sharing ? (*sharing)(mesh_.path.position(0, T_)) : 1.0;
  const double force = share * mesh_.scales.static_force;
  const DryContacts dry(DryForce(mesh_), mesh_, numbers, T_);
  const double dry_H0 = dry.balance(force);
  const std::vector<double> dry_forces = dry.forces(dry_H0);
  const Compliance compliance = mesh_.compliance(numbers, T_);
  const std::vector<double> displaced = compliance.displacements(dry_H0, dry_forces);
  motion_ = {};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    ContactFilm* film = free_film();
    film->set_conditions(mesh_.contact(numbers[k], T_).conditions);
    const bool carries = dry_forces[k] > 0.01 * force;
    const LoadCondition load =
        carries ? LoadCondition::force(dry_forces[k]) : LoadCondition::displacement(displaced[k]);
    const StationaryResult found =
        located(label(numbers[k]), [&] { return solve_stationary(*film, load, options_.films); });
    if (carries) motion_.H0 += (found.solution.H0 - (displaced[k] - dry_H0)) * dry_forces[k] / force;
    contacts_.push_back({numbers[k], film, still(found.solution.pressure)});
  }
  if (numbers.size() > 1) settle(LoadCondition::force(force, compliance));
}

// From films that are near.
void MeshMarch::settle(const LoadCondition& load) {
  const ScopedStage stage("Stationary film");
  const FilmSolution settled = located(label(contacts_.front().number) + " and its neighbours", [&] {
    return solve_together(present_films(), load, options_.films, {pressures(), motion_.H0});
  });
  set_pressures(settled.pressure);
  motion_.H0 = settled.H0;
}

std::vector<ContactFilm*> MeshMarch::present_films() const {
  std::vector<ContactFilm*> films;
  for (const LiveContact& contact : contacts_) {
    contact.film->set_conditions(mesh_.contact(contact.number, T_).conditions);
    films.push_back(contact.film);
  }
  return films;
}

std::vector<double> MeshMarch::pressures() const {
  std::vector<double> all;
  for (const LiveContact& contact : contacts_) {
    const std::vector<double>& own = values_of(contact.fields, field::pressure);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

void MeshMarch::set_pressures(std::span<const double> pressures) {
  for (LiveContact& contact : contacts_) {
    std::vector<double>& own = values_of(contact.fields, field::pressure);
    std::ranges::copy(pressures.first(own.size()), own.begin());
    pressures = pressures.subspan(own.size());
  }
}

void MeshMarch::start(const std::optional<Motion>& motion) {
  T_ = 0.0;
  if (motion) {
    motion_ = *motion;
    contacts_.clear();
    for (int number : mesh_.path.contacts_after(T_)) contacts_.push_back(enter(number));
    const Compliance compliance = mesh_.compliance(numbers(), T_);
    if (compliance.coupled()) settle(LoadCondition::displacement(motion_.H0, compliance));
  } else {
    balance_at_rest();
  }
  make_room();
  const std::vector<FilmFigures> figures = present_figures();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    check_validity(*contacts_[k].film, figures[k], label(contacts_[k].number));
  }
  observe_present();
}

void MeshMarch::observe(const StepRecord& record) const {
  observer_(record, contacts_);
  if (keeper_) keeper_->record(record);
}

std::vector<FilmFigures> MeshMarch::present_figures() const {
  const std::vector<double> displaced = displacements();
  const std::vector<ContactFilm*> films = present_films();
  std::vector<FilmFigures> figures;
  for (std::size_t k = 0; k < films.size(); ++k) {
    figures.push_back(films[k]->figures(values_of(contacts_[k].fields, field::pressure), displaced[k]));
  }
  return figures;
}

void MeshMarch::observe_present() const {
  StepRecord record;
  record.T = T_;
  record.motion = motion_;
  record.back_force = back_force(mesh_, motion_.H0, T_).value;
  const std::vector<FilmFigures> figures = present_figures();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    record.contacts.push_back(contact_record(mesh_, contacts_[k].number, T_, figures[k]));
  }
  observe(record);
}

void MeshMarch::exchange_contacts() {
  const std::vector<int> before = numbers(), after = mesh_.path.contacts_after(T_);
  if (before == after) return;
  std::map<int, FilmInPlace> films = films_in_place();
  std::erase_if(contacts_,
                [&](const LiveContact& contact) { return std::ranges::find(after, contact.number) == after.end(); });
  for (int number : after) {
    if (std::ranges::find(before, number) == before.end()) contacts_.push_back(enter(number));
  }
  // Teeth spring back that a force bent which is gone, and bend under one that is new.
  if (mesh_.compliance(numbers(), T_).coupled() || mesh_.compliance(before, T_).coupled()) {
    films.merge(films_in_place());  // of those that were there before as they were before
    follow(films);
  }
  observe_present();
}

PairState MeshMarch::state() const {
  PairState state{motion_, {}, discretisation_->grid().shape()};
  for (const LiveContact& contact : contacts_) state.films.push_back(contact.fields);
  return state;
}

void MeshMarch::resume(double T, const PairState& state) { take_up(T, state, mesh_.path.contacts_after(T)); }

void MeshMarch::take_up(double T, const PairState& state, const std::vector<int>& numbers) {
  T_ = T;
  motion_ = state.motion;
  if (numbers.size() != state.films.size()) {
    throw std::logic_error("a march cannot go on from " + std::to_string(state.films.size()) + " films with " +
                           std::to_string(numbers.size()) + " contacts");
  }
  if (!numbers.empty() && !same_lattice(discretisation_->grid().shape(), state.shape)) {
    throw std::logic_error("a march cannot go on from films on a grid of other steps");
  }
  contacts_.clear();
  if (!numbers.empty()) move_to(united(discretisation_->grid().shape(), state.shape));
  const PairState here = refitted(state, comm(), discretisation_->grid().shape());
  for (std::size_t k = 0; k < numbers.size(); ++k) contacts_.push_back({numbers[k], free_film(), here.films[k]});
}

std::map<int, MeshMarch::FilmInPlace> MeshMarch::films_in_place() const {
  const std::vector<double> displaced = displacements();
  const std::vector<ContactFilm*> films = present_films();
  std::map<int, FilmInPlace> in_place;
  for (std::size_t k = 0; k < films.size(); ++k) {
    const std::vector<double>& pressure = values_of(contacts_[k].fields, field::pressure);
    std::vector<double> oil(pressure.size());
    films[k]->mass(pressure, displaced[k], oil);
    in_place.emplace(contacts_[k].number, FilmInPlace{displaced[k], std::move(oil)});
  }
  return in_place;
}

// One implicit step of the change alone: G = 0 at the new displacements with
// d(rho H)/dT = rate + (rho H - rho H before)/dT, so that no jump is no change. Where films cannot follow at once, part
// of the jump is held back as a gap first.
void MeshMarch::follow(const std::map<int, FilmInPlace>& before) {
  constexpr double smallest_part = 1e-3;
  const double shift = 1.0 / options_.steps.dT;
  const LoadCondition load = LoadCondition::displacement(motion_.H0, mesh_.compliance(numbers(), T_));
  std::vector<double> held_back = displacements(), mass;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const FilmInPlace& own = before.at(contacts_[k].number);
    held_back[k] = own.displacement - held_back[k];
    const std::vector<double>& rate = values_of(contacts_[k].fields, field::rate);
    for (std::size_t n = 0; n < rate.size(); ++n) mass.push_back(own.oil[n] - rate[n] / shift);
  }
  const auto solved = [&](double part, const NewtonOptions& options) {
    const std::vector<ContactFilm*> films = present_films();
    for (std::size_t k = 0; k < films.size(); ++k) {
      ContactConditions conditions = films[k]->conditions();
      conditions.gap_offset += part * held_back[k];
      films[k]->set_conditions(conditions);
    }
    FilmSolution moved{pressures(), motion_.H0};
    if (!StationaryNewton(films, options).solve(load, moved, ImplicitStep{shift, mass})) return false;
    set_pressures(moved.pressure);
    return true;
  };
  for (double part = 1.0, step = 1.0; part > 0.0;) {
    const double next = std::max(0.0, part - step);
    if (solved(next, options_.steps.newton) || solved(next, options_.films.newton)) {
      part = next;
    } else if (step > smallest_part) {
      step *= 0.5;
    } else {
      throw SolveError(label(contacts_.front().number) + ": the films do not follow a jump of H by " +
                       std::to_string(-*std::ranges::max_element(held_back, {}, [](double x) { return std::abs(x); })));
    }
  }
  for (const auto& [number, now] : films_in_place()) {
    std::vector<double>& rate =
        values_of(std::ranges::find(contacts_, number, &LiveContact::number)->fields, field::rate);
    const std::vector<double>& oil = before.at(number).oil;
    for (std::size_t n = 0; n < rate.size(); ++n) rate[n] += shift * (now.oil[n] - oil[n]);
  }
}

void MeshMarch::displace(const Motion& motion) {
  const std::map<int, FilmInPlace> before = films_in_place();
  const bool jumps = motion.H0 != motion_.H0;
  motion_ = motion;
  if (jumps) follow(before);
  make_room();
  observe_present();
}

void MeshMarch::run_segment(double T_end, const StepOptions& steps, const std::optional<LoadSharing::Piece>& share) {
  const ScopedStage stage("Time steps");
  LubricatedPair pair(mesh_, contacts_, share);
  const FilmSystem& system = pair.system();
  const OwnedVec state = system.create_state();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    system.set_field(state, k, values_of(contacts_[k].fields, field::pressure));
  }
  pair.set_motion(state, motion_);
  SegmentStepper stepper(pair, steps, [&](const StepRecord& record) {
    T_ = record.T;
    motion_ = record.motion;
    Room needed;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const FilmFigures figures = film_figures(record.contacts[k].figures);
      needed = united(needed, needed_room(contacts_[k].number, figures.pressure_integral));
      check_validity(*contacts_[k].film, figures, label(contacts_[k].number));
    }
    observe(record);
    if (!has_room(needed)) stepper.stop();
  });
  T_ = stepper.run(state, T_, T_end);
  motion_ = pair.motion(state);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    values_of(contacts_[k].fields, field::pressure) = system.field(state, k);
    values_of(contacts_[k].fields, field::rate) = system.field(stepper.rate(), k);
  }
}

void MeshMarch::run(double T_end) {
  if (const auto kept = take_over(keeper_, T_, motion_, observer_)) {
    take_up(kept->T, kept->state, mesh_.path.contacts_before(kept->T));
  }
  // What happens between two segments follows from what is kept at the end of the first.
  for (exchange_contacts(); T_ < T_end - 1e-9 && !contacts_.empty(); exchange_contacts()) {
    make_room();
    double segment_end = std::min(T_end, mesh_.path.next_event(T_));
    StepOptions steps = options_.steps;
    const std::optional<LoadSharing::Piece> share = mesh_.share_from(T_);
    if (share) {
      segment_end = std::min(segment_end, mesh_.path.time_at(share->end));
      if (share->jump) steps.dT = std::min(steps.dT, (segment_end - T_) / mesh_.load->jump_refinement);
    }
    run_segment(segment_end, steps, share);
    if (keeper_) keeper_->keep(T_, state());
  }
}

}  // namespace gearfilm
