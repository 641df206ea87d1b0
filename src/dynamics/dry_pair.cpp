#include "gearfilm/dynamics/dry_pair.hpp"

#include <petscts.h>

#include <algorithm>
#include <cmath>

#include "gearfilm/error.hpp"
#include "gearfilm/mesh/back_flanks.hpp"

namespace gearfilm {

DryMarch::DryMarch(MeshModel mesh, double dT, StepObserver observer, double damping, MarchKeeper* keeper)
    : mesh_(std::move(mesh)),
      force_(mesh_),
      damping_(damping),
      dT_(dT),
      observer_(std::move(observer)),
      keeper_(keeper) {}

double DryMarch::total_force(const std::vector<int>& contacts, double T, double H0) const {
  return DryContacts(force_, mesh_, contacts, T).total_force(H0) - back_force(mesh_, H0, T).value;
}

void DryMarch::observe(double dT, double wall_seconds) const {
  StepRecord record;
  record.T = T_;
  record.dT = dT;
  record.motion = motion_;
  record.back_force = back_force(mesh_, motion_.H0, T_).value;
  record.wall_seconds = wall_seconds;
  std::vector<LiveContact> live;
  const std::vector<int> numbers = mesh_.path.contacts_after(T_);
  const std::vector<double> forces = DryContacts(force_, mesh_, numbers, T_).forces(motion_.H0);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const int contact = numbers[k];
    const ContactConditions conditions = mesh_.contact(contact, T_).conditions;
    FilmFigures figures;
    figures.pressure_integral = forces[k];
    if (figures.pressure_integral > 0.0) {
      figures.largest_pressure =
          dry_contact(mesh_.scales, conditions, figures.pressure_integral).pressure / mesh_.scales.pressure;
      figures.central_pressure = figures.largest_pressure;
    }
    record.contacts.push_back(contact_record(mesh_, contact, T_, figures));
    live.push_back({contact});
  }
  observer_(record, live);
  if (keeper_) keeper_->record(record);
}

void DryMarch::start(const std::optional<Motion>& motion) {
  T_ = 0.0;
  if (motion) {
    motion_ = *motion;
  } else {
    motion_ = balance(mesh_, force_, T_);
  }
  observe(0.0, 0.0);
}

Motion DryMarch::balance(const MeshModel& mesh, const DryForce& force, double T) {
  const DryContacts contacts(force, mesh, mesh.path.contacts_after(T), T);
  return {contacts.balance(mesh.scales.static_force), 0.0};
}

void DryMarch::integrate(const std::vector<int>& contacts, double T_end) {
  struct Context {
    const DryMarch* march;
    const std::vector<int>* contacts;
  } context{this, &contacts};
  PetscHandle<TS, TSDestroy> ts;
  OwnedVec state;
  petsc_check(VecCreateSeq(PETSC_COMM_SELF, 2, state.put()));
  {
    const VecWriting values(state);
    values[0] = motion_.H0;
    values[1] = motion_.V0;
  }
  petsc_check(TSCreate(PETSC_COMM_SELF, ts.put()));
  petsc_check(TSSetOptionsPrefix(ts, "dry_"));
  petsc_check(TSSetType(ts, TSRK));
  petsc_check(TSRKSetType(ts, TSRK5DP));
  petsc_check(TSSetRHSFunction(
      ts, nullptr,
      [](TS, PetscReal T, Vec in, Vec out, void* untyped) -> PetscErrorCode {
        return petsc_callback([&] {
          const auto& [march, present] = *static_cast<Context*>(untyped);
          const VecReading values(in);
          const VecWriting rates(out);
          rates[0] = values[1];
          rates[1] =
              (march->total_force(*present, T, values[0]) - march->mesh_.scales.static_force) / march->mesh_.inertia -
              march->damping_ * values[1];
        });
      },
      &context));
  petsc_check(TSSetTolerances(ts, integration_tolerance, nullptr, integration_tolerance, nullptr));
  petsc_check(TSSetExactFinalTime(ts, TS_EXACTFINALTIME_MATCHSTEP));
  petsc_check(TSSetMaxSteps(ts, 100000));
  petsc_check(TSSetTime(ts, T_));
  petsc_check(TSSetMaxTime(ts, T_end));
  petsc_check(TSSetTimeStep(ts, T_end - T_));
  petsc_check(TSSetFromOptions(ts));
  petsc_check(TSSolve(ts, state));
  const VecReading values(state);
  motion_ = {values[0], values[1]};
  if (!std::isfinite(motion_.H0) || !std::isfinite(motion_.V0)) {
    throw SolveError("the dry pair's motion is not finite at T = " + std::to_string(T_));
  }
  T_ = T_end;
}

void DryMarch::run(double T_end) {
  if (const auto kept = take_over(keeper_, T_, motion_, observer_)) {
    T_ = kept->T;
    motion_ = kept->state.motion;
  }
  while (T_ < T_end - 1e-9) {
    const std::vector<int> contacts = mesh_.path.contacts_after(T_);
    const double begin = T_, segment_end = std::min(T_end, mesh_.path.next_event(T_));
    const int steps = std::max(1, static_cast<int>(std::ceil((segment_end - begin) / dT_ - 1e-6)));
    for (int step = 1; step <= steps; ++step) {
      const double wall_start = MPI_Wtime(), before = T_;
      integrate(contacts, step == steps ? segment_end : begin + (segment_end - begin) * step / steps);
      observe(T_ - before, MPI_Wtime() - wall_start);
    }
    if (keeper_) keeper_->keep(T_, {motion_, {}}, {});
  }
}

}  // namespace gearfilm
