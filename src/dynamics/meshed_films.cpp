#include "dynamics/meshed_films.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "film/face_flow.hpp"
#include "film/rescaled_hertz_pressure.hpp"
#include "film/validity.hpp"
#include "gearfilm/error.hpp"
#include "grid/integral.hpp"
#include "grid/remap.hpp"
#include "mesh/dry_force.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
MeshedFilms::MeshedFilms(SharedDiscretisation discretisation, MeshModel mesh, MarchOptions options)
    : discretisation_(std::move(discretisation)), mesh_(std::move(mesh)), options_(std::move(options)) {}

std::string MeshedFilms::label(int number) const {
  return worded("contact ", number, " at xi = ", 1e3 * mesh_.path.position(number, T_), " mm (T = ", T_, ")");
}

std::vector<double> MeshedFilms::forces() const {
  return integrals(discretisation_->grid(), values(field::pressure), contacts_.size());
}

std::vector<double> MeshedFilms::displacements() const {
  return mesh_.compliance(numbers(), T_).displacements(motion_.H0(), forces());
}

std::vector<ContactFilm*> MeshedFilms::present_films() const {
  std::vector<ContactFilm*> films;
  for (const ActiveContact& contact : contacts_) {
    move_surfaces(*contact.film, mesh_.contact(contact.number, T_).conditions);
    films.push_back(contact.film);
  }
  return films;
}

std::vector<double> MeshedFilms::values(const ContactField& kind) const {
  std::vector<double> all;
  for (const ActiveContact& contact : contacts_) {
    const std::vector<double>& own = values_of(contact.fields, kind);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

void MeshedFilms::set_values(const ContactField& kind, std::span<const double> values) {
  for (ActiveContact& contact : contacts_) {
    std::vector<double>& own = values_of(contact.fields, kind);
    std::ranges::copy(values.first(own.size()), own.begin());
    values = values.subspan(own.size());
  }
}

// Films in wait still have the flow of the contact that left.
ContactFilm* MeshedFilms::free_film() {
  for (const auto& film : films_) {
    const auto uses = [&](const ActiveContact& contact) { return contact.film == film.get(); };
    if (std::any_of(contacts_.begin(), contacts_.end(), uses)) continue;
    film->set_flow_factors({});
    return film.get();
  }
  films_.push_back(std::make_unique<ContactFilm>(discretisation_, mesh_.scales, options_.films.multigrid));
  const double passed = cells_passed(mesh_, options_.steps.dT, discretisation_->grid().h_x());
  if (mesh_.inertia > 0.0 && third_order_damps_waves(passed)) {
    films_.back()->set_rates_in_wedge(rates_in_wedge(passed));
  }
  return films_.back().get();
}

void MeshedFilms::move_to(const GridShape& shape) {
  const SharedDiscretisation before = discretisation_;
  if (shape == before->grid().shape()) return;
  discretisation_ = discretise(Grid(comm(), shape), mesh_.scales, discretisation_->of_films());
  films_.clear();
  for (ActiveContact& contact : contacts_) contact.film = nullptr;
  for (ActiveContact& contact : contacts_) {
    contact.film = free_film();
    for (auto& [name, values] : contact.fields) values = remapped(values, before->grid(), discretisation_->grid());
    restore_processes(contact);
  }
}

void MeshedFilms::set_fields(std::size_t contact, std::vector<double> pressure, std::vector<double> rate) {
  ActiveContact& live = contacts_[contact];
  values_of(live.fields, field::pressure) = std::move(pressure);
  values_of(live.fields, field::rate) = std::move(rate);
  save_processes(live);
}

// The force grows with the power 3/2 of the approach, the half-axes with its root; where flanks have a local shape, the
// ellipse moves along the contact. Two steps ahead: in one the ellipse must not pass the edge.
DomainMargins MeshedFilms::required_margins(int number, double pressure_integral) const {
  if (!options_.margins || pressure_integral <= 0.0) return {};
  const ContactConditions conditions = mesh_.contact(number, T_).conditions;
  const double approach = dry_contact(mesh_.scales, conditions, pressure_integral).approach / mesh_.scales.thickness;
  const double sinking = std::max(0.0, -motion_.V0()) * 2.0 * options_.steps.largest();
  const double growth = std::sqrt(1.0 + std::min(0.5, sinking / approach));
  const auto room_of = [&](const ContactConditions& in) {
    return gearfilm::required_margins(*options_.margins, mesh_.scales, in, pressure_integral, label(number), growth);
  };
  const DomainMargins here = room_of(conditions);
  if (!conditions.local.flanks) return here;
  return enclosing(here, room_of(mesh_.contact(number, T_ + 2.0 * options_.steps.largest()).conditions));
}

bool MeshedFilms::grow_domain(const DomainMargins& needed) {
  if (fits(needed)) return false;
  const GridShape shape = widened(discretisation_->grid().shape(), needed, *options_.margins);
  if (options_.on_widening) options_.on_widening(comm(), shape);
  move_to(shape);
  return true;
}

bool MeshedFilms::grow_domain() {
  DomainMargins needed;
  if (!options_.margins) return false;
  const std::vector<double> carried = forces();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    needed = enclosing(needed, required_margins(contacts_[k].number, carried[k]));
  }
  return grow_domain(needed);
}

// Its neighbours bend its teeth; how it bends theirs, they record of when all contacts that exist from now on are
// there.
ActiveContact MeshedFilms::enter(int number, const std::vector<int>& together, std::vector<double> carried) {
  const ScopedStage stage("Entering film");
  const std::size_t own = std::ranges::find(together, number) - together.begin();
  carried.resize(together.size());
  carried[own] = 0.0;
  const Compliance compliance = mesh_.compliance(together, T_);
  const double displaced = compliance.displacements(motion_.H0(), carried)[own];
  const LoadCondition load = LoadCondition::displacement(displaced, compliance.alone(own));
  for (;;) {
    ContactFilm* film = free_film();
    move_surfaces(*film, mesh_.contact(number, T_).conditions);
    StationaryResult entered =
        located(label(number) + ", entering", [&] { return entering_.solve(*film, load, options_.films); });
    const DomainMargins needed = required_margins(number, entered.quantities.pressure_integral);
    if (fits(needed)) {
      check_validity(*film, entered.quantities, label(number));
      return located(label(number), [&] { return begin_contact(mesh_, number, film, load, options_.films, entered); });
    }
    grow_domain(needed);
  }
}

// Each film by itself as a dry contact's, then all of them together.
void MeshedFilms::balance_at_rest() {
  const std::vector<int> numbers = mesh_.path.contacts_after(T_);
  contacts_.clear();
  // None of them carries more than the whole force.
  DomainMargins needed;
  for (int number : numbers) needed = enclosing(needed, required_margins(number, mesh_.scales.static_force));
  grow_domain(needed);
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
    move_surfaces(*film, mesh_.contact(numbers[k], T_).conditions);
    const bool carries = dry_forces[k] > 0.01 * force;
    const LoadCondition load =
        carries ? LoadCondition::force(dry_forces[k]) : LoadCondition::displacement(displaced[k]);
    StationaryResult found = located(label(numbers[k]), [&] { return solve_stationary(*film, load, options_.films); });
    contacts_.push_back(located(label(numbers[k]),
                                [&] { return begin_contact(mesh_, numbers[k], film, load, options_.films, found); }));
    if (carries) motion_.H0() += (found.solution.H0 - (displaced[k] - dry_H0)) * dry_forces[k] / force;
  }
  if (numbers.size() > 1) settle(LoadCondition::force(force, compliance));
}

// One by one, beneath the forces of the others as they are: dry forces along a face are off by as much as bends teeth
// by more than a film.
void MeshedFilms::follow_neighbours(const Compliance& compliance) {
  constexpr int most_sweeps = 10;
  constexpr double settled = 1e-4;  // of a force
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0.0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      std::vector<double> carried = forces();
      const double before = carried[k];
      carried[k] = 0.0;
      const double displaced = compliance.displacements(motion_.H0(), carried)[k];
      std::vector<double>& pressure = values_of(contacts_[k].fields, field::pressure);
      const StationaryResult moved = located(label(contacts_[k].number), [&] {
        return continue_stationary(*present_films()[k], LoadCondition::displacement(displaced, compliance.alone(k)),
                                   options_.films, {pressure, displaced});
      });
      pressure = moved.solution.pressure;
      const double after = moved.quantities.pressure_integral;
      change = std::max(change, std::abs(after - before) / std::max(after, settled * mesh_.scales.static_force));
    }
    if (change < settled) break;
  }
}

// From films that are near.
void MeshedFilms::settle(const LoadCondition& load) {
  const ScopedStage stage("Stationary film");
  const FilmSolution settled = located(label(contacts_.front().number) + " and its neighbours", [&] {
    return solve_together(present_films(), load, options_.films, {values(field::pressure), motion_.H0()});
  });
  set_values(field::pressure, settled.pressure);
  motion_.H0() = settled.H0;
}

void MeshedFilms::start(const std::optional<Motion>& motion) {
  T_ = 0.0;
  if (motion) {
    motion_ = mesh_.in_train(*motion);
    contacts_.clear();
    // What films carry that do not exist yet, their dry contacts tell.
    const std::vector<int> numbers = mesh_.path.contacts_after(T_);
    const std::vector<double> dry = DryContacts(DryForce(mesh_), mesh_, numbers, T_).forces(motion_.H0());
    for (int number : numbers) contacts_.push_back(enter(number, numbers, dry));
    const Compliance compliance = mesh_.compliance(numbers, T_);
    if (compliance.coupled()) {
      if (mesh_.scales.face_law) follow_neighbours(compliance);
      settle(LoadCondition::displacement(motion_.H0(), compliance));
    }
  } else {
    balance_at_rest();
    motion_ = mesh_.in_train(motion_);
  }
  grow_domain();
  const std::vector<FilmQuantities> present = quantities();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    check_validity(*contacts_[k].film, present[k], label(contacts_[k].number));
  }
}

std::vector<FilmQuantities> MeshedFilms::quantities() const {
  const std::vector<double> displaced = displacements();
  const std::vector<ContactFilm*> films = present_films();
  std::vector<FilmQuantities> all;
  for (std::size_t k = 0; k < films.size(); ++k) {
    all.push_back(films[k]->quantities(values_of(contacts_[k].fields, field::pressure), displaced[k]));
  }
  return all;
}

std::vector<ContactRecord> MeshedFilms::records() const {
  const std::vector<FilmQuantities> present = quantities();
  return contact_records(mesh_, contacts_, T_, present);
}

std::map<int, double> MeshedFilms::displacement_by_number() const {
  const std::vector<double> displaced = displacements();
  std::map<int, double> by_number;
  for (std::size_t k = 0; k < contacts_.size(); ++k) by_number.emplace(contacts_[k].number, displaced[k]);
  return by_number;
}

bool MeshedFilms::exchange() {
  const std::vector<int> before = numbers(), after = mesh_.path.contacts_after(T_);
  if (before == after) return false;
  const std::map<int, double> displaced = displacement_by_number();
  std::erase_if(contacts_,
                [&](const ActiveContact& contact) { return std::ranges::find(after, contact.number) == after.end(); });
  for (int number : after) {
    if (std::ranges::find(before, number) == before.end()) contacts_.push_back(enter(number, after, forces()));
  }
  // Teeth spring back that a force bent which is gone, and bend under one that is new.
  if (mesh_.compliance(numbers(), T_).coupled() || mesh_.compliance(before, T_).coupled()) {
    follow(displaced, options_.steps.dT);
  }
  return true;
}

void MeshedFilms::displace(const Motion& motion, double duration) {
  const std::map<int, double> before = displacement_by_number();
  const bool jumps = motion.H0() != motion_.H0();
  motion_ = motion;
  if (jumps) follow(before, std::max(options_.steps.dT, duration));
  grow_domain();
}

std::vector<double> MeshedFilms::oil_at(const std::vector<double>& displacements) const {
  const std::vector<ContactFilm*> films = present_films();
  std::vector<double> all;
  for (std::size_t k = 0; k < films.size(); ++k) {
    const std::vector<double>& pressure = values_of(contacts_[k].fields, field::pressure);
    std::vector<double> own(pressure.size());
    films[k]->mass(pressure, displacements[k], own);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

PairState MeshedFilms::state() const {
  PairState state{motion_, {}, discretisation_->grid().shape()};
  for (const ActiveContact& contact : contacts_) state.films.push_back(contact.fields);
  return state;
}

void MeshedFilms::take_up(double T, const PairState& state, const std::vector<int>& numbers) {
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
  if (!numbers.empty()) move_to(enclosing(discretisation_->grid().shape(), state.shape));
  const PairState here = remapped(state, comm(), discretisation_->grid().shape());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    contacts_.push_back(continue_contact(mesh_, numbers[k], free_film(), here.films[k]));
  }
}

}  // namespace gearfilm
