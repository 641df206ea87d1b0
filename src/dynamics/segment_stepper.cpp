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
const Tuned<double> film_left("step_film_left", 0.7,
                              "part of the smallest film that a long step leaves, or it is made again as short ones");
const Tuned<int> short_steps("step_short_steps", 4, "short steps that give the first guess of a whole one");
const Tuned<int> short_halvings("step_short_halvings", 2, "halvings of a short step before that is given up");

// Motion is fitted to a swing of circular frequency w where w dT is above the first: below there is nothing to fit. It
// is taken to be at most the second: longer steps resolve no swing.
constexpr double shortest_swing_step = 1e-3, longest_swing_step = 1.5;

}  // namespace

double cells_passed(const MeshModel& mesh, double dT, double h_x) {
  return mesh.path.course().largest_speed() * dT / h_x;
}

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
      differences_([&] { return pair.system().create_state(); }),
      jacobian_(shell_jacobian(pair.system())) {
  petsc_check(SNESCreate(pair_.system().comm(), snes_.put()));
  petsc_check(SNESSetOptionsPrefix(snes_, "step_"));
  petsc_check(SNESSetFunction(snes_, rows_, Callback<&SegmentStepper::residual>::call, this));
  petsc_check(SNESSetJacobian(snes_, jacobian_, jacobian_, Callback<&SegmentStepper::linearise>::call, this));
  configure_newton(snes_, pair_.system(), options_.newton, pair_.system().weight());
  petsc_check(SNESSetComputeInitialGuess(snes_, Callback<&SegmentStepper::guess>::call, this));
  petsc_check(SNESSetFromOptions(snes_));
  if (options_.tolerance) {
    allowed_errors_ = pair_.allowed_errors(options_.tolerance->motion, options_.tolerance->pressure);
  }
}

void SegmentStepper::differentiate(double T, int order) {
  const bool third = order == 2 && pair_.mesh().inertia > 0.0 && differences_.evenly_spaced(T, 3);
  order_of_motion_ = third ? 3 : order;
  const double passed = cells_passed(pair_.mesh(), T - step_begin_, pair_.system().grid().h_x());
  const bool damped = third_order_damps_waves(passed);
  differences_.differentiate(T, third && damped ? 3 : order);
}

// Both formulas are s y + c of the y that is sought.
OwnRates SegmentStepper::rates_of_motion() const {
  if (order_of_motion_ == differences_.order()) return {};
  const std::vector<double> of_films = differences_.weights(differences_.order());
  const std::vector<double> own = differences_.weights(order_of_motion_);
  OwnRates rates{own[0] / of_films[0], Eigen::VectorXd::Zero(2 * pair_.mesh().freedoms())};
  for (std::size_t n = 1; n < own.size(); ++n) {
    const double by_films = n < of_films.size() ? rates.factor * of_films[n] : 0.0;
    rates.constant += (own[n] - by_films) * to_vector(pair_.motion(differences_.state(n - 1)));
  }
  return rates;
}

void SegmentStepper::step_motion() {
  const double dT = stage_time_ - step_begin_;
  const auto fit = [&](double rate) {
    double w = std::min(rate, longest_swing_step / dT);
    if (w * dT < shortest_swing_step) w = 0.0;
    return frequency_fit(w, differences_.of_oscillation(w, order_of_motion_));
  };
  pair_.step_motion(pair_.swings(solved_time_, solved_films_), fit, rates_of_motion());
}

void SegmentStepper::residual(SNES, Vec state, Vec rows) {
  pair_.place(stage_time_);
  pair_.system().transient(state, rate_);
  differences_.make_rate(rate_);
  pair_.system().residual(state, {rate_, stage_shift_}, rows);
}

void SegmentStepper::linearise(SNES, Vec state, Mat matrix, Mat) {
  pair_.place(stage_time_);
  pair_.linearise(state, {rate_, stage_shift_}, differences_.shift(),
                  failures_ == 0 ? SmootherFactors::of_earlier_states_too : SmootherFactors::of_this_state);
  petsc_check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  petsc_check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
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
    pair_.predict_for_load_share(state, solved_time_, stage_time_);
    pair_.predict_without_force(state, solved_time_, stage_time_, solved_films_);
  }
  pair_.system().clip_predictor(state, solved_);
  pair_.predict_for_motion(state, solved_, solved_time_, stage_time_, solved_films_);
  memory_.correct(pair_, state, stage_time_);
}

void SegmentStepper::set_solved(double T, Vec state) {
  solved_time_ = T;
  solved_films_ = pair_.film_quantities(state, T);
  solved_ = state;
}

void SegmentStepper::set_failures(int failures) {
  failures_ = failures;
  allow_growth(snes_, pair_.system(), failures == 1 ? Growth::none : Growth::tenfold);
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
  options.dT = (stage_time_ - solved_time_) / short_steps;
  options.max_rejections = short_halvings;
  options.guess_by_short_steps = false;
  PeriodicPredictor nothing;
  SegmentStepper shorter(pair_, nothing, options, [](const StepRecord&) {});
  const OwnedVec marched = pair_.system().create_state();
  petsc_check(VecCopy(solved_, marched));
  try {
    shorter.run(marched, solved_time_, stage_time_);
    petsc_check(VecCopy(marched, state));
  } catch (const SolveError&) {
    petsc_check(VecCopy(solved_, state));
  }
  step_motion();  // shorter ones had their own
  // They count as the step's own.
  newton_so_far_ -= shorter.newton_;
  krylov_so_far_ -= shorter.krylov_;
}

bool SegmentStepper::solve_stage(double T, int order) {
  stage_time_ = T;
  stage_shift_ = 1.5 / (T - step_begin_);
  differentiate(T, order);
  step_motion();
  petsc_check(SNESSolve(snes_, nullptr, differences_.sought()));
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  PetscInt newton = 0, krylov = 0;
  petsc_check(SNESGetConvergedReason(snes_, &reason));
  petsc_check(SNESGetIterationNumber(snes_, &newton));
  petsc_check(SNESGetLinearSolveIterations(snes_, &krylov));
  newton_ += newton;
  krylov_ += krylov;
  if (reason <= 0) {
    set_failures(failures_ + 1);
    return_to_start_of_step();
    return false;
  }
  memory_.record(pair_, differences_.sought(), solved_time_, T);
  set_solved(T, differences_.sought());
  at_start_ = false;
  return true;
}

void SegmentStepper::return_to_start_of_step() {
  set_solved(step_begin_, differences_.state(0));
  at_start_ = first_step_;
}

void SegmentStepper::keep(double T, bool behind) {
  pair_.place(T);
  differences_.keep(T, behind, [&](Vec state, Vec values) { pair_.system().transient(state, values); });
  solved_ = differences_.state(behind ? 1 : 0);
}

bool SegmentStepper::try_step(double dT, bool again) {
  if (first_step_) {  // of order 1 to its middle, and of order 2 from there
    petsc_check(VecCopy(differences_.state(0), differences_.sought()));
    if (!solve_stage(step_begin_ + 0.5 * dT, 1)) return false;
    differences_.forget(1);
    keep(stage_time_, true);
  }
  const std::vector<double> weights = differences_.extrapolate(step_begin_ + dT, again ? 2 : 3);
  // A run that goes on from a stored state knows of no earlier Jacobian by which films tell where oil flows freely.
  if (newton_ > 0) {
    pair_.system().extrapolate_falls(differences_.sought(), weights,
                                     [&](std::size_t n) { return differences_.state(n); });
  }
  return solve_stage(step_begin_ + dT, 2);
}

// As PETSc's basic controller.
bool SegmentStepper::control(double& dT, bool again) {
  constexpr double safety = 0.9, of_next_try = 0.5, round_off = 1e-8;
  const int order = std::min(2, differences_.known() - 1);
  const double error = differences_.error(stage_time_, order, allowed_errors_), shortest = smallest_step * options_.dT;
  const bool accepted = error <= 1.0 || first_step_ || dT < (1.0 + round_off) * shortest;
  const double factor = safety * (error > 1.0 && again ? of_next_try : 1.0) * std::pow(error, -1.0 / (order + 1));
  dT = std::clamp<double>(dT * std::clamp<double>(factor, longest_fall, longest_growth), shortest, options_.largest());
  return accepted;
}

// An entering contact that takes up its load long after it entered is closed by its teeth, faster than oil is carried
// through it. Rough surfaces carry each other where no film is left.
bool SegmentStepper::films_fall_too_far(const std::vector<FilmQuantities>& before, double part) const {
  if (pair_.mesh().scales.solids.rough) return false;
  const double left = std::pow(film_left, part);
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (solved_films_[k].smallest_film < left * before[k].smallest_film) return true;
  }
  return false;
}

// A step that was halved does not shift those behind it: the pair's motion after a period would jump.
double SegmentStepper::equal_step(double T) const {
  const double parts = T < falling_until_ - 1e-9 ? std::max(1.0, std::ceil(step_ / options_.of_falling_films)) : 1.0;
  const double step = step_ / parts, rest = end_ - T, done = std::floor((T - begin_) / step + 1e-6);
  return rest < 1.0001 * step ? rest : begin_ + (done + 1.0) * step - T;
}

double SegmentStepper::make_step(double dT) {
  keep(step_begin_, false);
  const std::vector<FilmQuantities> films = solved_films_;
  bool again = false;
  for (int tries = 0; tries <= options_.max_rejections + whole_tries(); ++tries, again = true) {
    if (!try_step(dT, again)) {
      if (failures_ > whole_tries()) dT *= 0.5;
      continue;
    }
    if (dT > options_.of_falling_films * (1.0 + 1e-9) && films_fall_too_far(films)) {
      falling_until_ = std::max(falling_until_, step_begin_ + options_.time_of_falling);
      dT = options_.of_falling_films;
      return_to_start_of_step();
      continue;
    }
    if (step_begin_ < falling_until_ && films_fall_too_far(films, dT / step_)) {
      falling_until_ = std::max(falling_until_, stage_time_ + options_.time_of_falling);
    }
    if (!options_.tolerance) return equal_step(stage_time_);
    if (control(dT, again)) {
      const double rest = end_ - stage_time_;
      return 1.01 * dT > rest ? rest : 2.0 * dT > rest ? 0.5 * rest : dT;
    }
    return_to_start_of_step();
  }
  throw SolveError(describe_failure());
}

void SegmentStepper::finish_step() {
  const double T = stage_time_;
  StepRecord record;
  record.halvings = std::max(0, failures_ - whole_tries());
  if (failures_ > 0) set_failures(0);
  record.T = T;
  record.dT = T - step_begin_;
  record.motion = pair_.motion(solved_);
  pair_.advance_processes(record.dT);
  record.contacts = pair_.records(T, solved_films_);
  record.back_force = reverse_flank_force(pair_.mesh(), record.motion, T).value;
  record.newton = static_cast<int>(newton_ - newton_so_far_);
  record.krylov = static_cast<int>(krylov_ - krylov_so_far_);
  record.wall_seconds = MPI_Wtime() - wall_start_;
  pair_.continue_friction(T, record.contacts);
  on_step_(record);
  step_begin_ = T;
  first_step_ = false;
  newton_so_far_ = newton_;
  krylov_so_far_ = krylov_;
  wall_start_ = MPI_Wtime();
}

std::string SegmentStepper::describe_end() const {
  KSP ksp = nullptr;
  const char *newton = nullptr, *krylov = nullptr;
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscInt iterations = 0;
  petsc_check(SNESGetConvergedReasonString(snes_, &newton));
  petsc_check(SNESGetKSP(snes_, &ksp));
  petsc_check(KSPGetConvergedReason(ksp, &reason));
  petsc_check(KSPGetConvergedReasonString(ksp, &krylov));
  petsc_check(KSPGetIterationNumber(ksp, &iterations));
  return worded(
      "Newton's method ended with ", newton,
      reason < 0 ? worded(", its last linear solve with ", krylov, " after ", iterations, " iterations") : "");
}

std::string SegmentStepper::describe_failure() const {
  std::ostringstream message;
  message << "no time step converged from T = " << step_begin_ << " on, down to " << step_ << "/2^"
          << options_.max_rejections << ", with";
  for (std::size_t k = 0; k < pair_.numbers().size(); ++k) {
    const int number = pair_.numbers()[k];
    message << (k > 0 ? ", contact " : " contact ") << number
            << " at xi = " << 1e3 * pair_.mesh().contact(number, step_begin_).position << " mm (largest "
            << describe(pair_.system().worst_node(rows_, k)) << ")";
  }
  message << "; " << describe_end()
          << "; use a smaller time step (time_dt), a finer grid (grid_nx, grid_ny) or a wider domain (grid_y_half)";
  return message.str();
}

double SegmentStepper::run(Vec state, double T0, double T1) {
  const double steps = std::max(1.0, std::ceil((T1 - T0) / options_.dT - 1e-6));
  const double round_off = 1e-9;  // of a step: not one more that is so short
  step_ = (T1 - T0) / steps;
  begin_ = step_begin_ = falling_until_ = T0;
  end_ = T1;
  differences_.forget();
  petsc_check(VecCopy(state, differences_.sought()));
  set_solved(T0, differences_.sought());
  at_start_ = first_step_ = true;
  stopped_ = false;
  set_failures(0);
  wall_start_ = MPI_Wtime();
  if (pair_.mesh().friction_couples_dynamics) pair_.begin_friction(T0, pair_.records(T0, solved_films_));
  double dT = std::min(T1 - T0, (options_.tolerance ? first_step : options_.first_part) * step_);
  do {
    dT = make_step(dT);
    finish_step();
  } while (!stopped_ && T1 - step_begin_ >= round_off * step_);
  petsc_check(VecCopy(solved_, state));
  pair_.system().copied(solved_, state);
  return stopped_ && T1 - step_begin_ > round_off * step_ ? step_begin_ : T1;
}

}  // namespace gearfilm
