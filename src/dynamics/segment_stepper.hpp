// Time integration of a lubricated pair between two events (entering or leaving of contacts).
//
// PETSc's TSBDF, order 2, with rho H as transient variable; it restarts by itself with a first-order half step, as the
// scheme must after every event. A step whose Newton iteration fails is never accepted. It is tried again as it was,
// from the films before it and with a residual that may only fall: slower, and surer. Then it is repeated with half the
// length, which a march over periods should not need: halved where another period's is not, they do not repeat. The
// nominal step comes back afterwards.
//
// With a tolerance, PETSc's basic controller chooses the steps by their local errors, from a small one after an event
// on. A march is the same whatever came before its segment; but periods do not repeat to the step, so that searches
// keep equal steps.
#pragma once

#include <petscts.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>

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
  NewtonOptions newton{.tolerance = 1e-5,
                       .max_iterations = 30,
                       .krylov_tolerance = 0.05,
                       .late_krylov_tolerance = 1e-3,
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

/// Newton's method for steps between rough surfaces, where many nodes fill and dry.
inline NewtonOptions rough_step_newton() {
  NewtonOptions options = StepOptions().newton;
  options.krylov_tolerance = 0.01;
  options.late_krylov_tolerance = 1e-5;
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
  using OwnedTS = PetscHandle<TS, TSDestroy>;

  static SegmentStepper& of(TS ts);
  // What PETSc calls.
  void transient(TS ts, Vec state, Vec values);
  void residual(TS ts, PetscReal T, Vec state, Vec rate, Vec rows);
  void linearise(TS ts, PetscReal T, Vec state, Vec rate, PetscReal shift, Mat matrix, Mat same);
  void guess(SNES snes, Vec state);
  TSAdapt adapt() const;
  void create_time_scheme();
  /// For the stage from begin to T.
  void fit_frequency(double begin, double T);
  void control_errors();
  void configure_solvers();
  /// What guesses go on from: the last stage that was solved, or the start of the step once a stage has failed.
  void set_solved(double T, Vec state);
  /// Sets how often the present step has failed, which decides how it is tried next.
  void set_failures(int failures);
  /// What was solved in it counts no more.
  void return_to_start_of_step();
  void finish_stage(double T, Vec state);
  void finish_step();
  /// How often a step that has failed is tried again as a whole, before it is halved.
  int whole_tries() const;
  /// The end of the step by shorter ones, which are no part of the march: its own errors stay those of equal steps.
  void guess_by_short_steps(Vec state);
  /// How the last solves ended.
  std::string describe_end() const;

  LubricatedPair& pair_;
  PeriodicPredictor& memory_;
  StepOptions options_;
  std::function<void(const StepRecord&)> on_step_;
  OwnedVec rows_;
  OwnedVec rate_;    ///< of the last residual: that of the accepted state, once a step is done
  OwnedVec solved_;  ///< see set_solved
  OwnedMat jacobian_;
  OwnedTS ts_;
  // C(state) depends on time through the geometry, but PETSc hands no time to it: this is the time of the state that
  // PETSc works on (that of the stage, or of the step's start once a stage has failed).
  double state_time_ = 0.0;
  bool stopped_ = false;
  int failures_ = 0;          ///< of the present step
  bool at_start_ = true;      ///< the next stage is the segment's first
  double stage_shift_ = 0.0;  ///< about d(rate)/dC of the present stage; PETSc gives it with the Jacobian only
  double step_ = 0.0;         ///< nominal step of the segment
  double begin_ = 0.0;        ///< T of the segment
  double last_time_ = 0.0;
  double solved_time_ = 0.0;
  std::vector<FilmQuantities> solved_films_;
  double wall_start_ = 0.0;
  PetscInt newton_so_far_ = 0;
  PetscInt krylov_so_far_ = 0;
};

}  // namespace gearfilm
