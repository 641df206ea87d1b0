#include "dynamics/dry_pair.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/reverse_flanks.hpp"

namespace gearfilm {

DryMarch::DryMarch(MeshModel mesh, double dT, StepObserver observer, double damping, RunStore* store)
    : mesh_(std::move(mesh)),
      force_(mesh_),
      flow_(DryFlow::in_time(mesh_, damping)),
      dT_(dT),
      observer_(std::move(observer)),
      store_(store) {}

void DryMarch::observe(double dT, double wall_seconds, const std::vector<int>& numbers) const {
  StepRecord record;
  record.T = T_;
  record.dT = dT;
  record.motion = motion_;
  record.back_force = reverse_flank_force(mesh_, motion_, T_).value;
  record.wall_seconds = wall_seconds;
  std::vector<ActiveContact> live;
  const std::vector<double> forces = DryContacts(force_, mesh_, numbers, T_).forces(motion_.H0());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const int contact = numbers[k];
    const ContactConditions conditions = mesh_.contact(contact, T_).conditions;
    FilmQuantities quantities;
    quantities.pressure_integral = forces[k];
    if (quantities.pressure_integral > 0.0) {
      quantities.largest_pressure =
          dry_contact(mesh_.scales, conditions, quantities.pressure_integral).pressure / mesh_.scales.pressure;
      quantities.central_pressure = quantities.largest_pressure;
    }
    record.contacts.push_back(contact_record(mesh_, contact, T_, quantities));
    live.push_back({contact});
  }
  observer_(record, live);
  if (store_) store_->record(record);
}

void DryMarch::start(const std::optional<Motion>& motion) {
  T_ = 0.0;
  motion_ = motion ? mesh_.in_train(*motion) : balance(mesh_, force_, T_);
  observe(0.0, 0.0, mesh_.path.contacts_after(T_));
}

Motion DryMarch::balance(const MeshModel& mesh, const DryForce& force, double T) {
  const DryContacts contacts(force, mesh, mesh.path.contacts_after(T), T);
  return mesh.in_train({contacts.balance(mesh.scales.static_force), 0.0});
}

void DryMarch::run(double T_end) {
  if (const auto kept = resume_from(store_, T_, motion_, observer_)) {
    T_ = kept->T;
    motion_ = kept->state.motion;
  }
  while (T_ < T_end - 1e-9) {
    const double begin = T_, segment_end = std::min(T_end, mesh_.path.next_event(T_));
    const std::vector<int> present = mesh_.path.contacts_after(begin);
    const int steps = std::max(1, static_cast<int>(std::ceil((segment_end - begin) / dT_ - 1e-6)));
    for (int step = 1; step <= steps; ++step) {
      const double wall_start = MPI_Wtime(), before = T_;
      T_ = step == steps ? segment_end : begin + (segment_end - begin) * step / steps;
      motion_ = flow_.between(motion_, before, T_);
      observe(T_ - before, MPI_Wtime() - wall_start, mesh_.train ? present : mesh_.path.contacts_after(T_));
    }
    // The energy of a drive train is summed from event to event: a record before each, and one behind it.
    const std::vector<int> next = mesh_.path.contacts_after(T_);
    if (mesh_.train && next != present) observe(0.0, 0.0, next);
    if (store_) store_->keep(T_, {motion_, {}}, {});
  }
}

}  // namespace gearfilm
