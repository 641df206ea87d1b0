#include "gearfilm/dynamics/mesh_march.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

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

MeshMarch::MeshMarch(SharedDiscretisation discretisation, const Scales& scales, const ContactPath& path, double inertia,
                     const SolverOptions& films, const StepOptions& steps, StepObserver observer,
                     std::optional<PrescribedLoad> load, MarchKeeper* keeper)
    : discretisation_(std::move(discretisation)),
      scales_(scales),
      path_(path),
      inertia_(inertia),
      film_options_(films),
      step_options_(steps),
      observer_(std::move(observer)),
      load_(std::move(load)),
      keeper_(keeper) {}

std::string MeshMarch::label(int contact) const {
  std::ostringstream text;
  text << "contact " << contact << " at xi = " << 1e3 * path_.position(contact, T_) << " mm (T = " << T_ << ")";
  return text.str();
}

ContactFilm* MeshMarch::free_film() {
  for (const auto& film : films_) {
    const auto uses = [&](const Tooth& tooth) { return tooth.film == film.get(); };
    if (std::none_of(teeth_.begin(), teeth_.end(), uses)) return film.get();
  }
  films_.push_back(std::make_unique<ContactFilm>(discretisation_, scales_, film_options_.multigrid));
  return films_.back().get();
}

MeshMarch::Tooth MeshMarch::enter(int contact, const ContactFields* neighbour) {
  const ScopedStage stage("Entering film");
  ContactFilm* film = free_film();
  film->set_conditions(path_.conditions(contact, T_));
  const LoadCondition load = LoadCondition::displacement(motion_.H0);
  StationaryResult entered = located(label(contact) + ", entering", [&] {
    return neighbour
               ? continue_stationary(*film, load, film_options_, {values_of(*neighbour, field::pressure), motion_.H0})
               : solve_stationary(*film, load, film_options_);
  });
  check_validity(*film, entered.figures, label(contact));
  return {contact, film, still(std::move(entered.solution.pressure))};
}

// A single contact is balanced together with its film; several by the secant method on H_0.
void MeshMarch::balance_at_rest() {
  const std::vector<int> contacts = path_.contacts_after(T_);
  teeth_.clear();
  ContactFilm* first = free_film();
  first->set_conditions(path_.conditions(contacts.front(), T_));
  const double share = load_ ? load_->sharing(path_.position(0, T_)) * scales_.static_force
                             : scales_.static_force / static_cast<double>(contacts.size());
  StationaryResult leading = located(
      label(contacts.front()), [&] { return solve_stationary(*first, LoadCondition::force(share), film_options_); });
  motion_ = {leading.solution.H0, 0.0};
  teeth_.push_back({contacts.front(), first, still(leading.solution.pressure)});
  if (contacts.size() == 1) return;

  const auto excess = [&](double H0) {
    motion_.H0 = H0;
    std::vector<Tooth> before = std::move(teeth_);
    teeth_.clear();
    double sum = -scales_.static_force;
    for (int contact : contacts) {
      const auto known =
          std::find_if(before.begin(), before.end(), [&](const Tooth& t) { return t.contact == contact; });
      teeth_.push_back(enter(contact, known != before.end() ? &known->state : &before.front().state));
      sum += teeth_.back().film->figures().pressure_integral;
    }
    return sum;
  };
  double H0 = motion_.H0, residual = excess(H0);
  double slope = -1.5 * scales_.static_force / scales_.approach;  // Hertz: F ~ approach^1.5
  for (int iteration = 0; std::abs(residual) > 1e-8 * scales_.static_force; ++iteration) {
    if (iteration == 30) throw SolveError("the contacts' forces at rest could not be balanced with the static force");
    const double next = H0 - residual / slope;
    const double next_residual = excess(next);
    // Films known to Newton's tolerance balance no better than that.
    const bool stalled = std::abs(next_residual) > 0.5 * std::abs(residual);
    if (stalled && std::abs(next_residual) < 1e-6 * scales_.static_force) return;
    slope = (next_residual - residual) / (next - H0);
    H0 = next;
    residual = next_residual;
  }
}

void MeshMarch::start(const std::optional<Motion>& motion) {
  T_ = 0.0;
  if (motion) {
    motion_ = *motion;
    teeth_.clear();
    for (int contact : path_.contacts_after(T_)) {
      teeth_.push_back(enter(contact, teeth_.empty() ? nullptr : &teeth_.back().state));
    }
  } else {
    balance_at_rest();
  }
  for (const Tooth& tooth : teeth_) check_validity(*tooth.film, tooth.film->figures(), label(tooth.contact));
  observe_present();
}

void MeshMarch::observe(const StepRecord& record) const {
  std::vector<LiveContact> live;
  for (const Tooth& tooth : teeth_) live.push_back({tooth.contact, tooth.film, &tooth.state});
  observer_(record, live);
  if (keeper_) keeper_->record(record);
}

void MeshMarch::observe_present() const {
  StepRecord record;
  record.T = T_;
  record.motion = motion_;
  for (const Tooth& tooth : teeth_) {
    tooth.film->evaluate(values_of(tooth.state, field::pressure).data(), motion_.H0);
    record.contacts.push_back(contact_record(path_, scales_, tooth.contact, T_, tooth.film->figures()));
  }
  observe(record);
}

void MeshMarch::exchange_contacts() {
  const std::vector<int> contacts = path_.contacts_after(T_);
  const std::size_t present = teeth_.size();
  std::erase_if(teeth_, [&](const Tooth& tooth) {
    return std::find(contacts.begin(), contacts.end(), tooth.contact) == contacts.end();
  });
  const std::size_t kept = teeth_.size();
  for (int contact : contacts) {
    const auto known = [&](const Tooth& tooth) { return tooth.contact == contact; };
    if (std::none_of(teeth_.begin(), teeth_.end(), known)) {
      teeth_.push_back(enter(contact, teeth_.empty() ? nullptr : &teeth_.back().state));
    }
  }
  if (kept != present || teeth_.size() != kept) observe_present();
}

std::vector<PairContact> MeshMarch::contacts() const {
  std::vector<PairContact> contacts;
  for (const Tooth& tooth : teeth_) contacts.push_back({tooth.contact, tooth.film});
  return contacts;
}

PairState MeshMarch::state() const {
  PairState state{motion_, {}};
  for (const Tooth& tooth : teeth_) state.films.push_back(tooth.state);
  return state;
}

void MeshMarch::resume(double T, const PairState& state) {
  T_ = T;
  motion_ = state.motion;
  const std::vector<int> contacts = path_.contacts_after(T_);
  if (contacts.size() != state.films.size()) {
    throw std::logic_error("a march cannot go on from " + std::to_string(state.films.size()) + " films with " +
                           std::to_string(contacts.size()) + " contacts");
  }
  teeth_.clear();
  for (std::size_t k = 0; k < contacts.size(); ++k) teeth_.push_back({contacts[k], free_film(), state.films[k]});
}

// One implicit step of the change alone: G = 0 at the new H_0 with d(rho H)/dT = rate + (rho H - rho H before)/dT, so
// that no jump is no change.
bool MeshMarch::follow(const Tooth& tooth, double H0, ContactFields& after) const {
  const double shift = 1.0 / step_options_.dT;
  tooth.film->set_conditions(path_.conditions(tooth.contact, T_));
  std::vector<double>& pressure = values_of(after, field::pressure);
  const std::vector<double>& rate = values_of(after, field::rate);
  std::vector<double> mass(pressure.size());
  tooth.film->storage(pressure.data(), motion_.H0, mass.data());
  for (std::size_t n = 0; n < mass.size(); ++n) mass[n] -= rate[n] / shift;
  for (const NewtonOptions& options : {step_options_.newton, film_options_.newton}) {
    StationaryNewton newton(*tooth.film, options);
    FilmSolution moved{pressure, H0};
    if (!newton.solve(LoadCondition::displacement(H0), moved, shift, mass.data())) continue;
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
    for (const Tooth& tooth : teeth_) {
      after.push_back(tooth.state);
      all = all && follow(tooth, H0, after.back());
    }
    if (all) {
      for (std::size_t k = 0; k < teeth_.size(); ++k) teeth_[k].state = std::move(after[k]);
      motion_.H0 = H0;
    } else if (std::abs(jump) > smallest_jump) {
      jump *= 0.5;
    } else {
      throw SolveError(label(teeth_.front().contact) + ": the film does not follow a jump of H0 to " +
                       std::to_string(motion.H0));
    }
  }
  motion_ = motion;
  observe_present();
}

void MeshMarch::run_segment(double T_end, const StepOptions& steps, const std::optional<LoadSharing::Piece>& share) {
  const ScopedStage stage("Time steps");
  LubricatedPair pair(path_, contacts(), inertia_, scales_, share);
  const OwnedVec state = pair.create_state();
  for (std::size_t k = 0; k < teeth_.size(); ++k) {
    pair.set_field(state, k, values_of(teeth_[k].state, field::pressure));
  }
  pair.set_motion(state, motion_);
  SegmentStepper stepper(pair, steps, [&](const StepRecord& record) {
    T_ = record.T;
    motion_ = record.motion;
    for (std::size_t k = 0; k < teeth_.size(); ++k) {
      check_validity(*teeth_[k].film, film_figures(record.contacts[k].figures), label(teeth_[k].contact));
    }
    observe(record);
  });
  stepper.run(state, T_, T_end);
  T_ = T_end;
  motion_ = pair.motion(state);
  for (std::size_t k = 0; k < teeth_.size(); ++k) {
    values_of(teeth_[k].state, field::pressure) = pair.field(state, k);
    values_of(teeth_[k].state, field::rate) = pair.field(stepper.rate(), k);
  }
}

void MeshMarch::run(double T_end) {
  if (const auto kept = take_over(keeper_, T_, motion_, observer_)) resume(kept->T, kept->state);
  while (T_ < T_end - 1e-9 && !teeth_.empty()) {
    double segment_end = std::min(T_end, path_.next_event(T_));
    StepOptions steps = step_options_;
    std::optional<LoadSharing::Piece> share;
    if (load_) {
      share = load_->sharing.piece_at(path_.position(0, T_));
      segment_end = std::min(segment_end, path_.time_at(share->end));
      if (share->jump) steps.dT = std::min(steps.dT, (segment_end - T_) / load_->jump_refinement);
    }
    run_segment(segment_end, steps, share);
    exchange_contacts();
    if (keeper_) keeper_->keep(T_, state());
  }
}

}  // namespace gearfilm
