// Time integration of a lubricated pair between two events (entering or leaving of contacts).
//
// Backward differences of order 2 (backward_differences.hpp) with rho H as transient variable; the first step after an
// event is a first-order half step and a second-order step from there. The motion, of which errors add up from swing to
// swing, has differences of order 3 once three steps are equally long. The films have where oil passes at most 0.6 of a
// cell in a step: in longer ones these would not damp all waves that oil carries.
//
// A step whose Newton iteration fails is never accepted. It is tried again as it was, from the films before it and with
// a residual that may only fall: slower, and surer. Then it is repeated with half the length, which a march over
// periods should not need: halved where another period's is not, they do not repeat. The nominal step comes back
// afterwards.
//
// With a tolerance steps are chosen by their local errors, from a small one after an event on. A march is the same
// whatever came before its segment; but periods do not repeat to the step, so that searches keep equal steps.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "dynamics/backward_differences.hpp"
#include "dynamics/lubricated_pair.hpp"
#include "dynamics/periodic_predictor.hpp"
#include "dynamics/step_record.hpp"

namespace gearfilm {

struct ErrorTolerance {
  double motion = 1e-5;        ///< of H_0, and of V_0 times half a free oscillation (at most times 1)
  double pressure = HUGE_VAL;  ///< root mean square over all nodes
};

struct StepOptions {
  double dT = 0.026;  ///< nominal time step [-]
  /// Without inertia: longest steps while the load passes to other contacts, and steps once no event disturbs films any
  /// more, where longer than dT.
  double of_transfer = HUGE_VAL, without_event = 0.0;
  /// Longest steps from where a film has fallen too far in a longer one, and the time for which they last.
  double of_falling_films = HUGE_VAL, time_of_falling = 0.0;
  NewtonOptions newton{.tolerance = 1e-5,
                       .max_iterations = 30,
                       .krylov_tolerance = 0.2,
                       .tightest_krylov_tolerance = 3e-4,
                       .krylov_max_iterations = 60,
                       .unsolved = 3,
                       .limit_changes = true};
  int max_rejections = 12;                    ///< halvings of one step before the run fails
  double first_part = 1.0;                    ///< of a step, with which a segment begins
  bool guess_by_short_steps = true;           ///< for a step that has failed twice, before it is halved
  std::optional<ErrorTolerance> tolerance{};  ///< on the local error of a step; equal steps where there is none

  double largest() const;
  /// All steps by a factor.
  void lengthen(double ratio);
};

/// Cells of h_x that oil passes in a step at most.
double cells_passed(const MeshModel& mesh, double dT, double h_x);

/// Cells that oil passes in the longest step in which films with differences of third order damp all waves that it
/// carries: with the wedge of `fitted` no wave of an even film grows up to 0.61 where oil conducts; elsewhere up to
/// 0.9, or 1.2 times this with rates in the wedge.
inline constexpr double longest_damped_step = 0.6;

/// Whether they do, where it passes so many cells in a step. Steps that fill a segment may be longer by 1e-6 of them
/// than the one that was asked for.
inline bool third_order_damps_waves(double passed) { return passed <= longest_damped_step * (1.0 + 1e-6); }

/// Newton's method for steps between rough surfaces, where many nodes fill and dry.
inline NewtonOptions rough_step_newton() {
  NewtonOptions options = StepOptions().newton;
  options.krylov_tolerance = 0.01;
  options.tightest_krylov_tolerance = 1e-5;
  return options;
}

/// Over a whole face a linearisation costs as much as many iterations of Krylov's method, of which few give a digit.
inline constexpr double krylov_tolerance_over_faces = 0.01;

class SegmentStepper {
public:
  /// on_step is called after every accepted step. Pair and memory must outlive the stepper.
  SegmentStepper(LubricatedPair& pair, PeriodicPredictor& memory, StepOptions options,
                 std::function<void(const StepRecord&)> on_step);
  SegmentStepper(const SegmentStepper&) = delete;
  SegmentStepper& operator=(const SegmentStepper&) = delete;

  /// Integrates the state from T0 to T1, and returns the time that it came to: earlier than T1 after stop(). Throws
  /// SolveError where a step cannot be made.
  double run(Vec state, double T0, double T1);
  /// Ends run() after the present step; called by on_step.
  void stop() { stopped_ = true; }

  /// d C(state)/dT at the end of run().
  Vec rate() const { return rate_; }

private:
  // What PETSc calls.
  void residual(SNES snes, Vec state, Vec rows);
  void linearise(SNES snes, Vec state, Mat matrix, Mat same);
  void guess(SNES snes, Vec state);
  /// Makes the differences of a stage at T, of this order at least.
  void differentiate(double T, int order);
  /// The rates of the motion, by those of the films.
  OwnRates rates_of_motion() const;
  /// Sets the motion's differences in the present stage, fitted to its swings.
  void step_motion();
  /// What guesses go on from: the last stage that was solved, or the start of the step once a stage has failed.
  void set_solved(double T, Vec state);
  /// Sets how often the present step has failed, which decides how it is tried next.
  void set_failures(int failures);
  /// The state that was solved for last becomes one of those that differences are made of, at T.
  void keep(double T, bool behind);
  /// Solves for the state at T from the guess in its place; false where that fails.
  bool solve_stage(double T, int order);
  /// What was solved in it counts no more.
  void return_to_start_of_step();
  /// All stages of a step; again: after a try that failed.
  bool try_step(double dT, bool again);
  /// Whether the local error of the step that was solved is accepted, and how long a step should be.
  bool control(double& dT, bool again);
  /// Whether the film of a contact has fallen since `before`, the begin of the step, by more than a step resolves; or
  /// by such a part of it as this is of a step.
  bool films_fall_too_far(const std::vector<FilmQuantities>& before, double part = 1.0) const;
  /// Length of the step from T on.
  double equal_step(double T) const;
  /// Solves a step of dT or, where that fails, of less. Returns the length of the next one.
  double make_step(double dT);
  void finish_step();
  /// How often a step that has failed is tried again as a whole, before it is halved.
  int whole_tries() const;
  /// The end of the step by shorter ones, which are no part of the march: its own errors stay those of equal steps.
  void guess_by_short_steps(Vec state);
  /// How the last solves ended.
  std::string describe_end() const;
  std::string describe_failure() const;

  LubricatedPair& pair_;
  PeriodicPredictor& memory_;
  StepOptions options_;
  std::function<void(const StepRecord&)> on_step_;
  OwnedVec rows_;
  OwnedVec rate_;  ///< of the last residual: that of the accepted state, once a step is done
  OwnedVec allowed_errors_;
  BackwardDifferences differences_;
  OwnedMat jacobian_;
  OwnedSNES snes_;
  bool stopped_ = false;
  int failures_ = 0;          ///< of the present step
  bool first_step_ = true;    ///< of the segment
  bool at_start_ = true;      ///< the next stage is the segment's first
  double stage_time_ = 0.0;   ///< T of the present stage
  double stage_shift_ = 0.0;  ///< about d(rate)/dC of the present stage
  int order_of_motion_ = 1;   ///< of its differences there
  double step_ = 0.0;         ///< nominal step of the segment
  double begin_ = 0.0;        ///< T of the segment
  double end_ = 0.0;
  double falling_until_ = 0.0;  ///< T up to which steps are those of falling films
  double step_begin_ = 0.0;     ///< of the present step
  Vec solved_ = nullptr;        ///< see set_solved
  double solved_time_ = 0.0;
  std::vector<FilmQuantities> solved_films_;
  double wall_start_ = 0.0;
  PetscInt newton_ = 0, krylov_ = 0;  ///< iterations
  PetscInt newton_so_far_ = 0, krylov_so_far_ = 0;
};

}  // namespace gearfilm
