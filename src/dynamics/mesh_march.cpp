#include "dynamics/mesh_march.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "film/validity.hpp"
#include "mesh/reverse_flanks.hpp"
#include "numerics/tuned.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
namespace {

/// The scheme begins with a first-order half step. Where nothing happens but that the grid is widened or steps become
/// longer it is to leave no trace: a step so short does not.
constexpr double part_without_event = 1.0 / 8.0;

const Tuned<double> time_to_pass("march_time_to_pass", 3.0,
                                 "time in which oil passes the contact, that films are given after an event");

/// A part of the march without inertia between two events.
struct BalancePhase {
  double end = 0.0;
  double dT = 0.0;
  bool transfers = false;  ///< the load passes to the contacts that are there
};

BalancePhase balance_phase(const ContactPath& path, double T, const StepOptions& steps) {
  const double transferred = path.last_event(T) + part_of_transfer * path.mesh_period();
  const double passed = transferred + time_to_pass;
  if (T < transferred - 1e-9) return {transferred, std::min(steps.dT, steps.of_transfer), true};
  if (T < passed - 1e-9) return {passed, steps.dT};
  return {HUGE_VAL, std::max(steps.dT, steps.without_event)};
}

}  // namespace

int step_levels(const Grid& grid, double dT) {
  const double widths = dT / grid.h_x();
  if (has_long_cells(grid) && widths <= 1.5) return 1;
  return grid.nx() * grid.ny() <= (widths <= 4.0 ? 50000 : 10000) ? 1 : 0;
}

MeshMarch::MeshMarch(SharedDiscretisation discretisation, MeshModel mesh, MarchOptions options, StepObserver observer,
                     RunStore* store)
    : films_(std::move(discretisation), std::move(mesh), std::move(options)),
      observer_(std::move(observer)),
      store_(store) {}

void MeshMarch::start(const std::optional<Motion>& motion) {
  films_.start(motion);
  observe_present();
}

void MeshMarch::displace(const Motion& motion, double duration) {
  films_.displace(motion, duration);
  observe_present();
}

void MeshMarch::resume(double T, const PairState& state) { films_.take_up(T, state, mesh().path.contacts_after(T)); }

std::vector<double> MeshMarch::memory() const {
  std::vector<double> values;
  films_.entering().append_to(values);
  guesses_.append_to(values);
  return values;
}

void MeshMarch::remember(std::span<const double> memory) {
  films_.entering() = {};
  guesses_ = {};
  if (memory.empty()) return;
  ValueReader values(memory);
  films_.entering().take_from(values);
  guesses_ = PeriodicPredictor(values);
}

void MeshMarch::show(const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  if (record.halvings > 0) ++halved_steps_;
  observer_(record, contacts);
}

void MeshMarch::observe(const StepRecord& record) {
  show(record, contacts());
  if (store_) store_->record(record);
}

void MeshMarch::observe_present() {
  StepRecord record;
  record.T = T();
  record.motion = motion();
  record.back_force = reverse_flank_force(mesh(), motion(), T()).value;
  record.contacts = films_.records();
  observe(record);
}

void MeshMarch::exchange_contacts() {
  if (films_.exchange()) observe_present();
}

void MeshMarch::run_segment(double T_end, const StepOptions& steps, const std::optional<LoadSharing::Piece>& share,
                            std::optional<double> transferred) {
  const ScopedStage stage("Time steps");
  LubricatedPair pair(mesh(), contacts(), share);
  if (transferred) {
    const std::vector<double> carried = films_.forces();
    pair.transfer_load(T(), *transferred, std::accumulate(carried.begin(), carried.end(), 0.0));
  }
  const FilmSystem& system = pair.system();
  const OwnedVec state = system.create_state();
  for (std::size_t k = 0; k < contacts().size(); ++k) {
    system.set_field(state, k, values_of(contacts()[k].fields, field::pressure));
  }
  pair.set_motion(state, motion());
  SegmentStepper stepper(pair, guesses_, steps, [&](const StepRecord& record) {
    films_.move(record.T, record.motion);
    DomainMargins needed;
    for (std::size_t k = 0; k < contacts().size(); ++k) {
      const ActiveContact& contact = contacts()[k];
      const FilmQuantities quantities = film_quantities(record.contacts[k].quantities);
      needed = enclosing(needed, films_.required_margins(contact.number, quantities.pressure_integral));
      check_validity(*contact.film, quantities, films_.label(contact.number));
    }
    observe(record);
    if (!films_.fits(needed)) stepper.stop();
  });
  const double come_to = stepper.run(state, T(), T_end);
  films_.move(come_to, pair.motion(state));
  for (std::size_t k = 0; k < contacts().size(); ++k) {
    films_.set_fields(k, system.field(state, k), system.field(stepper.rate(), k));
  }
  films_.adapt_rates();
}

void MeshMarch::run(double T_end) {
  const auto replayed = [&](const StepRecord& record, const std::vector<ActiveContact>& none) { show(record, none); };
  if (const auto kept = resume_from(store_, T(), motion(), replayed)) {
    films_.take_up(kept->T, kept->state, mesh().path.contacts_before(kept->T));
    remember(kept->memory);
  }
  // What happens between two segments follows from what is kept at the end of the first.
  for (exchange_contacts(); T() < T_end - 1e-9 && !contacts().empty(); exchange_contacts()) {
    const bool widened = films_.grow_domain();
    double segment_end = std::min(T_end, mesh().path.next_event(T()));
    StepOptions steps = films_.options().steps;
    steps.newton.tolerance *= looseness_;
    if (widened) steps.first_part = part_without_event;
    const std::optional<LoadSharing::Piece> share = mesh().share_from(T());
    if (share) {
      segment_end = std::min(segment_end, mesh().path.time_at(share->end));
      if (share->jump) steps.dT = std::min(steps.dT, (segment_end - T()) / mesh().load->jump_refinement);
    }
    std::optional<double> transferred;
    if (mesh().in_balance()) {
      const BalancePhase phase = balance_phase(mesh().path, T(), steps);
      segment_end = std::min(segment_end, phase.end);
      steps.of_falling_films = steps.dT;
      steps.time_of_falling = time_to_pass;
      steps.dT = phase.dT;
      if (phase.transfers) {
        transferred = phase.end;
        steps.tolerance.reset();
      } else {
        steps.first_part = part_without_event;
      }
    }
    run_segment(segment_end, steps, share, transferred);
    if (store_) store_->keep(T(), state(), memory());
  }
}

}  // namespace gearfilm
