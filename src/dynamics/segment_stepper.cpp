#include "dynamics/segment_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "gearfilm/error.hpp"
#include "mesh/reverse_flanks.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

// Of controlled steps, over the nominal one. The first after an event is taken whatever its error is.
const Tuned<double> first_step("step_first_step", 1.0 / 16.0,
                               "first controlled step after an event, over the nominal one");
const Tuned<double> largest_step("step_largest_step", 4.0, "largest controlled step");
const Tuned<double> smallest_step("step_smallest_step", 1e-4, "smallest controlled step");
const Tuned<double> longest_growth("step_longest_growth", 2.0, "largest growth of a controlled step");
const Tuned<double> longest_fall("step_longest_fall", 0.2, "largest fall of a controlled step");
const Tuned<int> short_steps("step_short_steps", 4, "short steps that give the first guess of a whole one");
const Tuned<int> short_halvings("step_short_halvings", 2, "halvings of a short step before that is given up");

// Motion is fitted to a swing of circular frequency w where w dT is above the first: below there is nothing to fit. It
// is taken to be at most the second: longer steps resolve no swing.
constexpr double shortest_swing_step = 1e-3, longest_swing_step = 1.5;

}  // namespace

double StepOptions::largest() const { return std::max(tolerance ? largest_step * dT : dT, without_event); }

void StepOptions::lengthen(double ratio) {
  dT *= ratio;
  of_transfer *= ratio;
  without_event *= ratio;
}

SegmentStepper::SegmentStepper(LubricatedPair& pair, PeriodicPredictor& memory, StepOptions options,
                               std::function<void(const StepRecord&)> on_step)
    : pair_(pair),
      memory_(memory),
      options_(std::move(options)),
      on_step_(std::move(on_step)),
      rows_(pair.system().create_state()),
      rate_(pair.system().create_state()),
      solved_(pair.system().create_state()),
      jacobian_(shell_jacobian(pair.system())) {
  create_time_scheme();
  configure_solvers();
}

void SegmentStepper::create_time_scheme() {
  petsc_check(TSCreate(pair_.system().comm(), ts_.put()));
  petsc_check(TSSetOptionsPrefix(ts_, "step_"));
  petsc_check(TSSetType(ts_, TSBDF));
  petsc_check(TSBDFSetOrder(ts_, 2));
  petsc_check(TSSetApplicationContext(ts_, this));
  petsc_check(TSSetTransientVariable(ts_, Callback<&SegmentStepper::transient>::call, this));
  petsc_check(TSSetIFunction(ts_, rows_, Callback<&SegmentStepper::residual>::call, this));
  petsc_check(TSSetIJacobian(ts_, jacobian_, jacobian_, Callback<&SegmentStepper::linearise>::call, this));
  petsc_check(TSSetPreStage(ts_, [](TS ts, PetscReal T) -> PetscErrorCode {
    return petsc_callback([&] {
      PetscReal begin = 0.0;
      petsc_check(TSGetTime(ts, &begin));
      if (of(ts).solved_time_ >= T) of(ts).return_to_start_of_step();
      of(ts).state_time_ = T;
      of(ts).stage_shift_ = 1.5 / (T - begin);
      of(ts).fit_frequency(begin, T);
    });
  }));
  petsc_check(TSSetPostStage(ts_, [](TS ts, PetscReal T, PetscInt, Vec* stages) -> PetscErrorCode {
    return petsc_callback([&] { of(ts).finish_stage(T, stages[0]); });
  }));
  petsc_check(
      TSSetPostStep(ts_, [](TS ts) -> PetscErrorCode { return petsc_callback([&] { of(ts).finish_step(); }); }));
  if (options_.tolerance) {
    control_errors();
  } else {
    petsc_check(TSAdaptSetType(adapt(), TSADAPTNONE));
  }
  petsc_check(TSSetExactFinalTime(ts_, TS_EXACTFINALTIME_MATCHSTEP));
  petsc_check(TSSetMaxSNESFailures(ts_, -1));
  petsc_check(TSSetMaxStepRejections(ts_, options_.max_rejections + whole_tries()));
  petsc_check(TSSetErrorIfStepFails(ts_, PETSC_FALSE));
  petsc_check(TSSetMaxSteps(ts_, PETSC_MAX_INT - 1));
}

// The first step of a segment is a BDF1 step to its middle, and a BDF2 step from there.
void SegmentStepper::fit_frequency(double begin, double T) {
  PetscInt steps = 0;
  PetscReal before = 0.0;
  petsc_check(TSGetStepNumber(ts_, &steps));
  petsc_check(TSGetPrevTime(ts_, &before));
  const double half = 0.5 * (T - begin);
  pair_.fit_frequencies(pair_.swings(solved_time_, solved_films_), [&](double rate) {
    double w = std::min(rate, longest_swing_step / (T - begin));
    if (w * (T - begin) < shortest_swing_step) w = 0.0;
    return frequency_fit(w, at_start_    ? derivative_by_bdf1(w, T - begin)
                            : steps == 0 ? derivative_by_bdf2(w, half, half)
                                         : derivative_by_bdf2(w, T - begin, begin - before));
  });
}

void SegmentStepper::transient(TS, Vec state, Vec values) {
  pair_.place(state_time_);
  // Between two stages PETSc asks for copies of the state that was solved last.
  if (state_time_ == solved_time_) pair_.system().copied(solved_, state);
  pair_.system().transient(state, values);
}

void SegmentStepper::residual(TS, PetscReal T, Vec state, Vec rate, Vec rows) {
  pair_.place(T);
  pair_.system().residual(state, {rate, stage_shift_}, rows);
  petsc_check(VecCopy(rate, rate_));
}

void SegmentStepper::linearise(TS, PetscReal T, Vec state, Vec rate, PetscReal shift, Mat matrix, Mat) {
  pair_.place(T);
  pair_.linearise(state, {rate, stage_shift_}, shift,
                  failures_ == 0 ? SmootherFactors::of_earlier_states_too : SmootherFactors::of_this_state);
  petsc_check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  petsc_check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
}

void SegmentStepper::control_errors() {
  petsc_check(TSAdaptSetType(adapt(), TSADAPTBASIC));
  petsc_check(TSAdaptSetClip(adapt(), longest_fall, longest_growth));
  petsc_check(TSAdaptSetStepLimits(adapt(), smallest_step * options_.dT, options_.largest()));
  const OwnedVec errors = pair_.allowed_errors(options_.tolerance->motion, options_.tolerance->pressure);
  petsc_check(TSSetTolerances(ts_, 0.0, errors, 0.0, nullptr));
}

TSAdapt SegmentStepper::adapt() const {
  TSAdapt own = nullptr;
  petsc_check(TSGetAdapt(ts_, &own));
  return own;
}

SegmentStepper& SegmentStepper::of(TS ts) {
  void* context = nullptr;
  petsc_check(TSGetApplicationContext(ts, &context));
  return *static_cast<SegmentStepper*>(context);
}

void SegmentStepper::configure_solvers() {
  SNES snes = nullptr;
  petsc_check(TSGetSNES(ts_, &snes));
  configure_newton(snes, pair_.system(), options_.newton, pair_.system().weight());
  petsc_check(SNESSetComputeInitialGuess(snes, Callback<&SegmentStepper::guess>::call, this));
  petsc_check(TSSetFromOptions(ts_));
}

// The predictor extrapolates, badly where the contact's edge draws back across a node: there pressure falls ever more
// slowly. In the first stage it knows no velocity: where the gears part Newton's method would not find the receding
// edge (42 iterations, and halved steps, at half the natural frequency), under a rising load it would have to find
// the oil outside the contact that the sinking body squeezes.
void SegmentStepper::guess(SNES, Vec state) {
  if (failures_ == 1) {
    petsc_check(VecCopy(solved_, state));
    return;
  }
  if (failures_ == 2 && whole_tries() == 2) return guess_by_short_steps(state);
  if (at_start_) {
    pair_.predict_for_load_share(state, solved_time_, state_time_);
    pair_.predict_without_force(state, solved_time_, state_time_, solved_films_);
  }
  pair_.system().clip_predictor(state, solved_);
  pair_.predict_for_motion(state, solved_, solved_time_, state_time_, solved_films_);
  memory_.correct(pair_, state, state_time_);
}

void SegmentStepper::set_solved(double T, Vec state) {
  solved_time_ = T;
  solved_films_ = pair_.film_quantities(state, T);
  petsc_check(VecCopy(state, solved_));
  pair_.system().copied(state, solved_);
}

void SegmentStepper::set_failures(int failures) {
  failures_ = failures;
  const bool same_length = failures <= whole_tries();
  SNES snes = nullptr;
  petsc_check(TSGetSNES(ts_, &snes));
  petsc_check(TSAdaptSetScaleSolveFailed(adapt(), same_length ? 1.0 : 0.5));
  allow_growth(snes, pair_.system(), failures == 1 ? Growth::none : Growth::tenfold);
}

// From the last state, and from where shorter steps lead; but what friction and heat carry along is the march's alone.
int SegmentStepper::whole_tries() const {
  const MeshModel& mesh = pair_.mesh();
  const bool by_short_steps =
      options_.guess_by_short_steps && !options_.tolerance && !mesh.friction_couples_dynamics && !mesh.corrects_films();
  return by_short_steps ? 2 : 1;
}

void SegmentStepper::guess_by_short_steps(Vec state) {
  StepOptions options = options_;
  options.dT = (state_time_ - solved_time_) / short_steps;
  options.max_rejections = short_halvings;
  options.guess_by_short_steps = false;
  PeriodicPredictor nothing;
  SegmentStepper shorter(pair_, nothing, options, [](const StepRecord&) {});
  const OwnedVec marched = pair_.system().create_state();
  petsc_check(VecCopy(solved_, marched));
  try {
    shorter.run(marched, solved_time_, state_time_);
    petsc_check(VecCopy(marched, state));
  } catch (const SolveError&) {
    petsc_check(VecCopy(solved_, state));
  }
  PetscReal begin = 0.0;
  petsc_check(TSGetTime(ts_, &begin));
  fit_frequency(begin, state_time_);  // shorter ones had fits of their own
  // They count as the step's own.
  PetscInt newton = 0, krylov = 0;
  petsc_check(TSGetSNESIterations(shorter.ts_, &newton));
  petsc_check(TSGetKSPIterations(shorter.ts_, &krylov));
  newton_so_far_ -= newton;
  krylov_so_far_ -= krylov;
}

void SegmentStepper::finish_stage(double T, Vec state) {
  SNES snes = nullptr;
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  petsc_check(TSGetSNES(ts_, &snes));
  petsc_check(SNESGetConvergedReason(snes, &reason));
  if (reason > 0) {
    memory_.record(pair_, state, solved_time_, T);
    set_solved(T, state);
    at_start_ = false;
    return;
  }
  set_failures(failures_ + 1);
  return_to_start_of_step();
}

void SegmentStepper::return_to_start_of_step() {
  Vec step_start = nullptr;
  PetscInt steps = 0;
  petsc_check(TSGetTime(ts_, &state_time_));
  petsc_check(TSGetSolution(ts_, &step_start));
  petsc_check(TSGetStepNumber(ts_, &steps));
  set_solved(state_time_, step_start);
  at_start_ = steps == 0;
}

// PETSc calls this after failed steps too, and leaves a shortened step short for ever.
void SegmentStepper::finish_step() {
  TSConvergedReason reason = TS_CONVERGED_ITERATING;
  petsc_check(TSGetConvergedReason(ts_, &reason));
  if (reason < 0) return;
  PetscReal T = 0.0, end = 0.0;
  PetscInt newton = 0, krylov = 0;
  Vec state = nullptr;
  petsc_check(TSGetTime(ts_, &T));
  petsc_check(TSGetMaxTime(ts_, &end));
  petsc_check(TSGetSNESIterations(ts_, &newton));
  petsc_check(TSGetKSPIterations(ts_, &krylov));
  petsc_check(TSGetSolution(ts_, &state));
  pair_.system().copied(solved_, state);
  StepRecord record;
  record.halvings = std::max(0, failures_ - whole_tries());
  if (failures_ > 0) set_failures(0);
  record.T = T;
  record.dT = T - last_time_;
  record.motion = pair_.motion(state);
  const std::vector<FilmQuantities> quantities = pair_.film_quantities(state, T);
  pair_.advance_processes(record.dT);
  record.contacts = pair_.records(T, quantities);
  record.back_force = reverse_flank_force(pair_.mesh(), record.motion, T).value;
  record.newton = newton - newton_so_far_;
  record.krylov = krylov - krylov_so_far_;
  record.wall_seconds = MPI_Wtime() - wall_start_;
  pair_.continue_friction(T, record.contacts);
  on_step_(record);
  last_time_ = T;
  newton_so_far_ = newton;
  krylov_so_far_ = krylov;
  wall_start_ = MPI_Wtime();
  const double rest = end - T;
  if (stopped_ || rest < 1e-9 * step_) {  // not one more step of the size of round-off
    petsc_check(TSSetConvergedReason(ts_, stopped_ ? TS_CONVERGED_USER : TS_CONVERGED_TIME));
  } else if (options_.tolerance) {
    petsc_check(TSAdaptSetAlwaysAccept(adapt(), PETSC_FALSE));
  } else {
    // A step that was halved does not shift those behind it: the pair's motion after a period would jump.
    const double done = std::floor((T - begin_) / step_ + 1e-6);
    petsc_check(TSSetTimeStep(ts_, rest < 1.0001 * step_ ? rest : begin_ + (done + 1.0) * step_ - T));
  }
}

std::string SegmentStepper::describe_end() const {
  SNES snes = nullptr;
  KSP ksp = nullptr;
  const char *newton = nullptr, *krylov = nullptr;
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscInt iterations = 0;
  petsc_check(TSGetSNES(ts_, &snes));
  petsc_check(SNESGetConvergedReasonString(snes, &newton));
  petsc_check(SNESGetKSP(snes, &ksp));
  petsc_check(KSPGetConvergedReason(ksp, &reason));
  petsc_check(KSPGetConvergedReasonString(ksp, &krylov));
  petsc_check(KSPGetIterationNumber(ksp, &iterations));
  return worded(
      "Newton's method ended with ", newton,
      reason < 0 ? worded(", its last linear solve with ", krylov, " after ", iterations, " iterations") : "");
}

double SegmentStepper::run(Vec state, double T0, double T1) {
  const double steps = std::max(1.0, std::ceil((T1 - T0) / options_.dT - 1e-6));
  step_ = (T1 - T0) / steps;
  begin_ = state_time_ = last_time_ = T0;
  set_solved(T0, state);
  at_start_ = true;
  stopped_ = false;
  set_failures(0);
  wall_start_ = MPI_Wtime();
  if (pair_.mesh().friction_couples_dynamics)
    pair_.begin_friction(T0, pair_.records(T0, pair_.film_quantities(state, T0)));
  petsc_check(TSSetTime(ts_, T0));
  petsc_check(TSSetStepNumber(ts_, 0));
  petsc_check(TSSetMaxTime(ts_, T1));
  petsc_check(TSSetTimeStep(ts_, (options_.tolerance ? first_step : options_.first_part) * step_));
  if (options_.tolerance) {
    petsc_check(TSAdaptSetAlwaysAccept(adapt(), PETSC_TRUE));
  }
  petsc_check(TSSolve(ts_, state));
  TSConvergedReason reason = TS_CONVERGED_ITERATING;
  petsc_check(TSGetConvergedReason(ts_, &reason));
  if (reason > 0) return stopped_ && T1 - last_time_ > 1e-9 * step_ ? last_time_ : T1;
  std::ostringstream message;
  message << "no time step converged from T = " << last_time_ << " on, down to " << step_ << "/2^"
          << options_.max_rejections << ", with";
  for (std::size_t k = 0; k < pair_.numbers().size(); ++k) {
    const int number = pair_.numbers()[k];
    message << (k > 0 ? ", contact " : " contact ") << number
            << " at xi = " << 1e3 * pair_.mesh().contact(number, last_time_).position << " mm (largest "
            << describe(pair_.system().worst_node(rows_, k)) << ")";
  }
  message << "; " << describe_end()
          << "; use a smaller time step (time_dt), a finer grid (grid_nx, grid_ny) or a wider domain (grid_y_half)";
  throw SolveError(message.str());
}

}  // namespace gearfilm
