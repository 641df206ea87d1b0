#include "dynamics/dry_flow.hpp"

#include <petscts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "dynamics/train_rates.hpp"
#include "gearfilm/error.hpp"
#include "mesh/reverse_flanks.hpp"

namespace gearfilm {
namespace {

// Absolute and relative. Where a gap closes, the force has a kink and steps are cut elsewhere for every start: the map
// jumps by some ten times its tolerance, which must lie below what Newton's methods on it ask for.
constexpr double integration_tolerance = 1e-10;  // of the motion
constexpr double map_tolerance = 1e-12;          // of the motion with its derivatives; of a drive train's
constexpr double derivative_tolerance = 1e-8;    // of the derivatives of a drive train's motion

/// q, v; then Phi row by row, and w.
std::vector<double> beginning(const Motion& start, bool derivatives) {
  const Eigen::VectorXd x = to_vector(start);
  std::vector<double> values(x.begin(), x.end());
  if (!derivatives) return values;
  const std::size_t size = values.size();
  values.resize(size * (size + 2), 0.0);
  for (std::size_t n = 0; n < size; ++n) values[size + n * (size + 1)] = 1.0;
  return values;
}

/// H_0 between two steps, by its values and slopes there (cubic of Hermite); s = 0 to 1.
struct Cubic {
  double before, after;     ///< H_0
  double rate, rate_after;  ///< dT V_0

  double operator()(double s) const {
    const double r = 1.0 - s;
    return r * r * ((1.0 + 2.0 * s) * before + s * rate) + s * s * ((1.0 + 2.0 * r) * after - r * rate_after);
  }
  /// Where its slope is zero, if it changes sign.
  std::optional<double> turning() const {
    if (rate * rate_after >= 0.0) return {};
    // (rate) + 2 b s + 3 a s^2 = 0
    const double a = rate + rate_after - 2.0 * (after - before), b = 3.0 * (after - before) - 2.0 * rate - rate_after;
    const double root = std::sqrt(std::max(0.0, b * b - 3.0 * a * rate));
    const double q = -(b + std::copysign(root, b));
    for (const double s : {q / (3.0 * a), rate / q}) {
      if (s >= 0.0 && s <= 1.0) return s;
    }
    return {};
  }
};

}  // namespace

/// One way through some mesh periods, or a short one.
class DryFlowRun {
public:
  /// With derivatives; without them, the extremes on the way known; the end alone.
  enum class Kind { map, march, step };

  /// From s on.
  DryFlowRun(const DryFlow& flow, const Motion& start, Kind kind, double s = 0.0)
      : flow_(&flow), values_(beginning(start, kind == Kind::map)), size_(2 * start.freedoms()), kind_(kind), s_(s) {
    forget_extremes();
    petsc_check(
        VecCreateSeqWithArray(PETSC_COMM_SELF, 1, static_cast<PetscInt>(values_.size()), values_.data(), state_.put()));
    petsc_check(TSCreate(PETSC_COMM_SELF, ts_.put()));
    petsc_check(TSSetOptionsPrefix(ts_, "dry_"));
    petsc_check(TSSetType(ts_, TSRK));
    const bool train = flow.here_.mesh.train != nullptr, map = kind == Kind::map, step = kind == Kind::step;
    petsc_check(TSRKSetType(ts_, step && !train ? TSRK5DP : TSRK8VR));
    petsc_check(TSSetRHSFunction(ts_, nullptr, Callback<&DryFlowRun::rates>::call, this));
    const double tolerance = map || (step && train) ? map_tolerance : integration_tolerance;
    petsc_check(TSSetTolerances(ts_, tolerance, nullptr, tolerance, nullptr));
    if (train && map) set_tolerances(tolerance);
    petsc_check(TSSetExactFinalTime(ts_, TS_EXACTFINALTIME_MATCHSTEP));
    petsc_check(TSSetMaxSteps(ts_, 1000000));
    if (kind != Kind::step) petsc_check(TSMonitorSet(ts_, Callback<&DryFlowRun::step_done>::call, this, nullptr));
    petsc_check(TSSetFromOptions(ts_));
  }

  /// Anew, as one that was made with these: one of the same kind.
  void begin(const DryFlow& flow, const Motion& start, double s) {
    flow_ = &flow;
    const VecWriting x(state_);
    std::ranges::copy(beginning(start, kind_ == Kind::map), x.values().begin());
    petsc_check(TSSetStepNumber(ts_, 0));
    forces_.clear();
    s_ = s;
    step_ = 0.0;
  }

  void run(double s_end) {
    const double T_m = flow_->here_.period;
    while (s_ < s_end - 1e-9) {
      contacts_ = flow_->here_.mesh.path.contacts_after(s_ * T_m);
      const double end = std::min(s_end, next_stop(s_ * T_m) / T_m);
      begins_ = true;
      petsc_check(TSSetTime(ts_, s_));
      petsc_check(TSSetMaxTime(ts_, end));
      if (step_ == 0.0) step_ = (kind_ == Kind::step ? 1.0 : 0.05) * (end - s_);
      petsc_check(TSSetTimeStep(ts_, std::min(step_, end - s_)));
      petsc_check(TSRestartStep(ts_));
      petsc_check(TSSolve(ts_, state_));
      s_ = end;
    }
    if (!std::ranges::all_of(values_, [](double value) { return std::isfinite(value); })) {
      const bool step = kind_ == Kind::step;
      throw SolveError("the dry pair's motion is not finite ", step ? "at T = " : "after ", s_end,
                       step ? "" : " mesh period(s)");
    }
  }

  Eigen::Index freedoms() const { return size_ / 2; }
  Motion motion() const { return motion_in(values_.data()); }
  Eigen::MatrixXd by_start() const { return Eigen::Map<const RowMajor>(values_.data() + size_, size_, size_); }
  Motion by_parameter() const { return motion_in(values_.data() + size_ * (size_ + 1)); }
  const DryExtremes& extremes() const { return extremes_; }
  void forget_extremes() {
    extremes_ = {};
    extremes_.smallest_force = extremes_.least_approach = std::numeric_limits<double>::max();
  }

private:
  /// Where contacts enter and leave; of a drive train also where reliefs begin, about which steps would be short.
  double next_stop(double T) const {
    const MeshModel& mesh = flow_->here_.mesh;
    double next = mesh.path.next_event(T);
    if (!mesh.train) return next;
    for (const double xi : mesh.teeth.relief_places()) next = std::min(next, mesh.path.next_passage(xi, T));
    return next;
  }

  /// Derivatives say how fast Newton's method converges, and the multipliers: they need not be as accurate as the
  /// motion itself. Their kinks where gaps close are sharper than its own, and would cost most of the steps.
  void set_tolerances(double of_motion) {
    petsc_check(VecDuplicate(state_, tolerances_.put()));
    {
      const VecWriting tolerances(tolerances_);
      std::ranges::fill(tolerances.values(), derivative_tolerance);
      std::ranges::fill(tolerances.values().first(static_cast<std::size_t>(size_)), of_motion);
    }
    petsc_check(TSSetTolerances(ts_, PETSC_DEFAULT, tolerances_, PETSC_DEFAULT, tolerances_));
  }

  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Motion motion_in(const double* x) const { return motion_from({x, static_cast<std::size_t>(size_)}); }

  /// T_m dV_0/dT, and its derivative by H_0 on demand.
  double acceleration(const DryFlow::Pair& pair, double s, double H0, double V0, double* slope) const {
    const double T = s * pair.period;
    const DryContacts contacts(pair.force, pair.mesh, contacts_, T);
    const std::vector<double> forces = contacts.forces(H0);
    const ReverseForce back = reverse_flank_force(pair.mesh, H0, T);
    const double total = std::accumulate(forces.begin(), forces.end(), -back.value);
    if (slope) *slope = -pair.period * (contacts.stiffness(forces) + back.slope) / pair.mesh.inertia;
    return pair.period * ((total - pair.mesh.scales.static_force) / pair.mesh.inertia - pair.damping * V0);
  }

  void rates(TS, PetscReal s, Vec in, Vec out) {
    const DryFlow::Pair& here = flow_->here_;
    const VecReading x(in);
    const VecWriting rate(out);
    if (here.mesh.train) {
      train_rates(s, x.values().data(), rate.values().data());
      return;
    }
    const double H0 = x[0], V0 = x[1];
    double slope = 0.0;
    rate[0] = here.period * V0;
    rate[1] = acceleration(here, s, H0, V0, kind_ == Kind::map ? &slope : nullptr);
    if (kind_ != Kind::map) return;
    // Columns of Phi, then w.
    for (const auto& [first, second] : {std::pair{2, 4}, std::pair{3, 5}, std::pair{6, 7}}) {
      rate[first] = here.period * x[second];
      rate[second] = slope * x[first] - here.period * here.damping * x[second];
    }
    if (!flow_->beside_) return;
    rate[6] += (flow_->beside_->period - here.period) * V0 / flow_->part_;
    rate[7] += (acceleration(*flow_->beside_, s, H0, V0, nullptr) - rate[1]) / flow_->part_;
  }

  DryContacts contacts_of(const DryFlow::Pair& pair, double s) const {
    return {pair.force, pair.mesh, contacts_, s * pair.period};
  }

  static TrainAcceleration acceleration(const DryFlow::Pair& pair, double s, const LoadedContacts& loaded,
                                        const Motion& motion, bool derivatives) {
    return train_acceleration(pair.mesh, loaded, s * pair.period, motion, pair.damping, derivatives);
  }

  /// x' of a pair in a drive train, and below it the rates of Phi and w, as of a pair alone.
  void train_rates(double s, const double* x, double* rate) {
    const DryFlow::Pair& here = flow_->here_;
    const Motion motion = motion_in(x);
    const Eigen::Index n = motion.freedoms();
    const bool map = kind_ == Kind::map;
    const DryContacts contacts = contacts_of(here, s);
    forces_ = contacts.forces_near(motion.H0(), forces_);
    const TrainAcceleration forced = acceleration(here, s, {contacts, forces_}, motion, map);
    Eigen::Map<Eigen::VectorXd> of_motion(rate, size_);
    of_motion << here.period * motion.v, here.period * forced.value;
    if (!map) return;
    // Phi, and w as a column of its own: the upper half of the slope is that of q' = v.
    const Eigen::MatrixXd by_q = here.period * forced.by_displacement, by_v = here.period * forced.by_velocity;
    const auto apply = [&](const auto& of, auto&& to) {
      to.topRows(n) = here.period * of.bottomRows(n);
      to.bottomRows(n) = by_q.lazyProduct(of.topRows(n)) + by_v.lazyProduct(of.bottomRows(n));
    };
    apply(Eigen::Map<const RowMajor>(x + size_, size_, size_), Eigen::Map<RowMajor>(rate + size_, size_, size_));
    const Eigen::Index w = size_ * (size_ + 1);
    Eigen::Map<Eigen::VectorXd> of_parameter(rate + w, size_);
    apply(Eigen::Map<const Eigen::VectorXd>(x + w, size_), of_parameter);
    if (!flow_->beside_) return;
    of_parameter.head(n) += (flow_->beside_->period - here.period) / flow_->part_ * motion.v;
    of_parameter.tail(n) += (beside_acceleration(s, contacts, motion) - here.period * forced.value) / flow_->part_;
  }

  /// T_m times the acceleration of the pair beside, where the contacts of this one are these.
  Eigen::VectorXd beside_acceleration(double s, const DryContacts& contacts, const Motion& motion) const {
    const DryFlow::Pair& beside = *flow_->beside_;
    if (flow_->same_contacts_) return beside.period * acceleration(beside, s, {contacts, forces_}, motion, false).value;
    const DryContacts others = contacts_of(beside, s);
    const std::vector<double> forces = others.forces_near(motion.H0(), forces_);
    return beside.period * acceleration(beside, s, {others, forces}, motion, false).value;
  }

  void step_done(TS, PetscInt, PetscReal s, Vec state) {
    const VecReading x(state);
    const Motion motion = motion_in(x.values().data());
    if (!begins_) look_between(s, motion);
    look_at(s, motion.H0());
    if (s > seen_s_ && !begins_) step_ = s - seen_s_;
    begins_ = false;
    seen_s_ = s;
    seen_ = motion;
  }

  /// H_0 has its extremes between steps.
  void look_between(double s, const Motion& motion) {
    const double ds = s - seen_s_, dT = ds * flow_->here_.period;
    const Cubic cubic{seen_.H0(), motion.H0(), dT * seen_.V0(), dT * motion.V0()};
    if (const std::optional<double> part = cubic.turning()) look_at(seen_s_ + *part * ds, cubic(*part));
  }

  void look_at(double s, double H0) {
    const DryContacts contacts(flow_->here_.force, flow_->here_.mesh, contacts_, s * flow_->here_.period);
    const std::vector<double> forces = contacts.forces(H0);
    extremes_.largest_force = std::max(extremes_.largest_force, *std::ranges::max_element(forces));
    extremes_.smallest_force = std::min(extremes_.smallest_force, std::accumulate(forces.begin(), forces.end(), 0.0));
    extremes_.least_approach = std::min(extremes_.least_approach, contacts.largest_approach(H0));
  }

  const DryFlow* flow_;
  std::vector<double> values_;
  Eigen::Index size_;  ///< of q and v
  Kind kind_;
  OwnedVec state_, tolerances_;
  PetscHandle<TS, TSDestroy> ts_;
  std::vector<int> contacts_;
  std::vector<double> forces_;  ///< where they were computed last
  double s_;
  double step_ = 0.0;  ///< the last one: a good beginning behind an event
  bool begins_ = true;
  double seen_s_ = 0.0;
  Motion seen_;
  DryExtremes extremes_;
};

namespace {

/// At the same parts of a mesh period, as places all over it tell.
template <class Pair>
bool have_same_contacts(const Pair& one, const Pair& other) {
  constexpr int places = 16;
  for (int n = 0; n < places; ++n) {
    const double s = (n + 0.5) / places;
    const auto contacts = [s](const Pair& pair) {
      const double T = s * pair.period;
      return DryContacts(pair.force, pair.mesh, pair.mesh.path.contacts_after(T), T);
    };
    if (!contacts(one).same_as(contacts(other))) return false;
  }
  return true;
}

}  // namespace

DryFlow::DryFlow(Pair here, std::optional<Pair> beside, double part)
    : here_(std::move(here)),
      beside_(std::move(beside)),
      part_(part),
      same_contacts_(beside_ && here_.mesh.train && have_same_contacts(here_, *beside_)) {}

DryFlow::DryFlow(const MeshModel& mesh, const MeshModel& beside, double part, double damping_ratio)
    : DryFlow(Pair(mesh, dry_damping(mesh, damping_ratio), mesh.path.mesh_period()),
              Pair(beside, dry_damping(beside, damping_ratio), beside.path.mesh_period()), part) {}

DryFlow::DryFlow(const MeshModel& mesh, double damping_ratio)
    : DryFlow(Pair(mesh, dry_damping(mesh, damping_ratio), mesh.path.mesh_period()), {}, 1.0) {}

DryFlow DryFlow::in_time(const MeshModel& mesh, double damping) { return {Pair(mesh, damping, 1.0), {}, 1.0}; }

Motion DryFlow::between(const Motion& start, double T_begin, double T_end) const {
  if (steps_ && steps_->freedoms() == start.freedoms()) {
    steps_->begin(*this, start, T_begin);
  } else {
    steps_ = std::make_shared<DryFlowRun>(*this, start, DryFlowRun::Kind::step, T_begin);
  }
  steps_->run(T_end);
  return steps_->motion();
}

void DryFlow::march(const MeshModel& mesh, double damping_ratio, const Motion& start, int mesh_periods,
                    const std::function<void(const DryPeriod&)>& observer) {
  const DryFlow flow(mesh, damping_ratio);
  DryFlowRun run(flow, start, DryFlowRun::Kind::march);
  for (int n = 1; n <= mesh_periods; ++n) {
    run.run(n);
    observer({run.motion(), run.extremes()});
    run.forget_extremes();
  }
}

DryFlowEnd DryFlow::operator()(const Motion& start, int mesh_periods) const {
  DryFlowRun run(*this, start, DryFlowRun::Kind::map);
  DryFlowEnd end;
  for (int n = 1; n <= mesh_periods; ++n) {
    run.run(n);
    end.states.push_back(run.motion());
  }
  end.by_start = run.by_start();
  end.by_parameter = run.by_parameter();
  end.extremes = run.extremes();
  return end;
}

}  // namespace gearfilm
