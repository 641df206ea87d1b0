#include "gearfilm/dynamics/mesh_march.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

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

// The force grows with the power 3/2 of the approach, the half-axes with its root. Two steps ahead: in one the ellipse
// must not pass the edge.
Room MeshMarch::needed_room(int number, double pressure_integral) const {
  if (!options_.room || pressure_integral <= 0.0) return {};
  const ContactConditions conditions = mesh_.contact(number, T_).conditions;
  const double approach = dry_contact(mesh_.scales, conditions, pressure_integral).approach / mesh_.scales.thickness;
  const double sinking = std::max(0.0, -motion_.V0) * 2.0 * options_.steps.dT;
  const double growth = std::sqrt(1.0 + std::min(0.5, sinking / approach));
  return gearfilm::needed_room(*options_.room, mesh_.scales, conditions, pressure_integral, label(number), growth);
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
  for (const LiveContact& contact : contacts_) {
    needed = united(needed, needed_room(contact.number, present_figures(contact).pressure_integral));
  }
  make_room(needed);
}

LiveContact MeshMarch::enter(int number, const std::optional<PressureGuess>& guess) {
  const ScopedStage stage("Entering film");
  const LoadCondition load = LoadCondition::displacement(motion_.H0);
  for (;;) {
    ContactFilm* film = free_film();
    film->set_conditions(mesh_.contact(number, T_).conditions);
    StationaryResult entered = located(label(number) + ", entering", [&] {
      if (!guess) return solve_stationary(*film, load, options_.films);
      const std::vector<double> pressure = refitted(guess->values, Grid(comm(), guess->shape), film->grid());
      return continue_stationary(*film, load, options_.films, {pressure, motion_.H0});
    });
    const Room needed = needed_room(number, entered.figures.pressure_integral);
    if (has_room(needed)) {
      check_validity(*film, entered.figures, label(number));
      return {number, film, still(std::move(entered.solution.pressure))};
    }
    make_room(needed);
  }
}

// A single contact is balanced together with its film; several by the secant method on H_0.
void MeshMarch::balance_at_rest() {
  const std::vector<int> numbers = mesh_.path.contacts_after(T_);
  contacts_.clear();
  // None of them carries more than the whole force.
  Room needed;
  for (int number : numbers) needed = united(needed, needed_room(number, mesh_.scales.static_force));
  make_room(needed);
  ContactFilm* first = free_film();
  first->set_conditions(mesh_.contact(numbers.front(), T_).conditions);
  const auto sharing = mesh_.share_from(T_);
  const double share = sharing ? (*sharing)(mesh_.path.position(0, T_)) : 1.0 / static_cast<double>(numbers.size());
  const LoadCondition load = LoadCondition::force(share * mesh_.scales.static_force);
  StationaryResult leading =
      located(label(numbers.front()), [&] { return solve_stationary(*first, load, options_.films); });
  motion_ = {leading.solution.H0, 0.0};
  contacts_.push_back({numbers.front(), first, still(leading.solution.pressure)});
  if (numbers.size() == 1) return;

  const auto excess = [&](double H0) {
    motion_.H0 = H0;
    std::map<int, PressureGuess> before;
    for (const LiveContact& contact : contacts_) before.emplace(contact.number, pressure_of(contact));
    contacts_.clear();
    double sum = -mesh_.scales.static_force;
    for (int number : numbers) {
      const auto known = before.find(number);
      contacts_.push_back(enter(number, known != before.end() ? known->second : before.begin()->second));
      sum += present_figures(contacts_.back()).pressure_integral;
    }
    return sum;
  };
  double H0 = motion_.H0, residual = excess(H0);
  double slope = -mesh_.stiffness();
  for (int iteration = 0; std::abs(residual) > 1e-8 * mesh_.scales.static_force; ++iteration) {
    if (iteration == 30) throw SolveError("the contacts' forces at rest could not be balanced with the static force");
    const double next = H0 - residual / slope;
    const double next_residual = excess(next);
    // Films known to Newton's tolerance balance no better than that.
    const bool stalled = std::abs(next_residual) > 0.5 * std::abs(residual);
    if (stalled && std::abs(next_residual) < 1e-6 * mesh_.scales.static_force) return;
    slope = (next_residual - residual) / (next - H0);
    H0 = next;
    residual = next_residual;
  }
}

void MeshMarch::start(const std::optional<Motion>& motion) {
  T_ = 0.0;
  if (motion) {
    motion_ = *motion;
    contacts_.clear();
    for (int number : mesh_.path.contacts_after(T_)) {
      contacts_.push_back(enter(number, guess_from_last()));
    }
  } else {
    balance_at_rest();
  }
  make_room();
  for (const LiveContact& contact : contacts_) {
    check_validity(*contact.film, present_figures(contact), label(contact.number));
  }
  observe_present();
}

void MeshMarch::observe(const StepRecord& record) const {
  observer_(record, contacts_);
  if (keeper_) keeper_->record(record);
}

FilmFigures MeshMarch::present_figures(const LiveContact& contact) const {
  contact.film->set_conditions(mesh_.contact(contact.number, T_).conditions);
  return contact.film->figures(values_of(contact.fields, field::pressure), motion_.H0);
}

void MeshMarch::observe_present() const {
  StepRecord record;
  record.T = T_;
  record.motion = motion_;
  for (const LiveContact& contact : contacts_) {
    record.contacts.push_back(contact_record(mesh_, contact.number, T_, present_figures(contact)));
  }
  observe(record);
}

void MeshMarch::exchange_contacts() {
  const std::vector<int> numbers = mesh_.path.contacts_after(T_);
  const std::size_t present = contacts_.size();
  std::erase_if(contacts_, [&](const LiveContact& contact) {
    return std::ranges::find(numbers, contact.number) == numbers.end();
  });
  const std::size_t kept = contacts_.size();
  for (int number : numbers) {
    if (std::ranges::find(contacts_, number, &LiveContact::number) == contacts_.end()) {
      contacts_.push_back(enter(number, guess_from_last()));
    }
  }
  if (kept != present || contacts_.size() != kept) observe_present();
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

// One implicit step of the change alone: G = 0 at the new H_0 with d(rho H)/dT = rate + (rho H - rho H before)/dT, so
// that no jump is no change.
bool MeshMarch::follow(const LiveContact& contact, double H0, ContactFields& after) const {
  const double shift = 1.0 / options_.steps.dT;
  contact.film->set_conditions(mesh_.contact(contact.number, T_).conditions);
  std::vector<double>& pressure = values_of(after, field::pressure);
  const std::vector<double>& rate = values_of(after, field::rate);
  std::vector<double> mass(pressure.size());
  contact.film->mass(pressure, motion_.H0, mass);
  for (std::size_t n = 0; n < mass.size(); ++n) mass[n] -= rate[n] / shift;
  for (const NewtonOptions& options : {options_.steps.newton, options_.films.newton}) {
    StationaryNewton newton(*contact.film, options);
    FilmSolution moved{pressure, H0};
    if (!newton.solve(LoadCondition::displacement(H0), moved, ImplicitStep{shift, mass})) continue;
    pressure = std::move(moved.pressure);
    return true;
  }
  return false;
}

// A film that cannot follow at once does so in smaller jumps.
void MeshMarch::displace(const Motion& motion) {
  constexpr double smallest_jump = 1e-3;
  double jump = motion.H0 - motion_.H0;
  while (motion_.H0 != motion.H0) {
    const double left = motion.H0 - motion_.H0;
    const double H0 = std::abs(left) <= std::abs(jump) * (1.0 + 1e-9) ? motion.H0 : motion_.H0 + jump;
    std::vector<ContactFields> after;
    bool all = true;
    for (const LiveContact& contact : contacts_) {
      after.push_back(contact.fields);
      all = all && follow(contact, H0, after.back());
    }
    if (all) {
      for (std::size_t k = 0; k < contacts_.size(); ++k) contacts_[k].fields = std::move(after[k]);
      motion_.H0 = H0;
    } else if (std::abs(jump) > smallest_jump) {
      jump *= 0.5;
    } else {
      throw SolveError(label(contacts_.front().number) + ": the film does not follow a jump of H0 to " +
                       std::to_string(motion.H0));
    }
  }
  motion_ = motion;
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
