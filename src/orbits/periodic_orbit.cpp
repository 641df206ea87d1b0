#include "orbits/periodic_orbit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algebra/dense.hpp"
#include "gearfilm/error.hpp"
#include "grid/remap.hpp"
#include "numerics/tuned.hpp"
#include "orbits/map_jacobian.hpp"

namespace gearfilm {
namespace {

const Tuned<double> difference_step("orbit_difference_step", 2e-3, "step of differences of the map");
const Tuned<double> telling_step("orbit_telling_step", 3e-3,
                                 "step of the motion by which the map's Jacobian is measured");
const Tuned<double> worth_keeping("orbit_worth_keeping", 5e-3, "defect of a period whose end serves as a disturbance");
const Tuned<double> far_off("orbit_far_off", 100.0,
                            "defect, in the tolerance, beyond which a period's steps are solved loosely");
const Tuned<double> looseness("orbit_looseness", 10.0, "Newton's tolerance in periods far from repeating");
const Tuned<double> largest_change("orbit_largest_change", 0.5, "largest change of the motion in a Newton step");
const Tuned<double> shortest_step("orbit_shortest_step", 0.2,
                                  "shortest part of a Newton step before the Jacobian is doubted");
const Tuned<int> settling_periods("orbit_settling_periods", 3,
                                  "periods marched on before Newton's method is tried again");
// That films have to follow a Newton step, a tenth of that in which oil passes the contact: of all times between a step
// and a mesh period the one after which films repeat best.
const Tuned<double> time_to_follow("orbit_time_to_follow", 0.2, "time in which films follow a Newton step");

/// x with map x = right.
Motion preimage(const Monodromy& map, const Motion& right) { return to_motion(solved(map, to_vector(right))); }

/// What a field has changed by over its nodes.
struct FieldChange {
  double largest = 0.0;
  double squares = 0.0, nodes = 0.0;
  double size = 0.0;  ///< largest value

  void add(double first, double second) {
    largest = std::max(largest, std::abs(second - first));
    squares += (second - first) * (second - first);
    size = std::max(size, std::abs(second));
    ++nodes;
  }
  /// Over the nodes of all processes: the largest change, or the root mean square over the largest value.
  double over_all(MPI_Comm comm, bool mean) {
    std::array maxima{largest, size}, sums{squares, nodes};
    MPI_Allreduce(MPI_IN_PLACE, maxima.data(), 2, MPI_DOUBLE, MPI_MAX, comm);
    if (!mean) return maxima[0];
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), 2, MPI_DOUBLE, MPI_SUM, comm);
    return maxima[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) / maxima[1] : 0.0;
  }
};

/// Largest change of any field between two states with the same contacts. mean: of films that feel their heat, which
/// goes on flickering at single nodes of the exit.
double film_change(const PairState& earlier, const PairState& after, MPI_Comm comm, bool mean) {
  const PairState before = remapped(earlier, comm, after.shape);
  double largest = 0.0;
  for (std::size_t k = 0; k < before.films.size() && k < after.films.size(); ++k) {
    const std::vector<double>& pressed = values_of(before.films[k], field::pressure);
    const std::vector<double>& presses = values_of(after.films[k], field::pressure);
    for (const auto& [name, first] : before.films[k]) {
      const ContactField kind = field_named(name);
      if (!kind.compared) continue;
      const std::vector<double>& second = after.films[k].at(name);
      FieldChange change;
      for (std::size_t n = 0; n < first.size(); ++n) {
        if (kind.loaded_only && (pressed[n] <= 0.0 || presses[n] <= 0.0)) continue;
        change.add(first[n], second[n]);
      }
      largest = std::max(largest, change.over_all(comm, mean));
    }
  }
  return largest;
}

/// A period that was marched to its end.
struct Trial {
  PairState start;
  PairState end;
  std::optional<PairState> before{};
  double begin = 0.0;
  Motion defect{};
  double film_defect = 0.0;
  bool loose = false;  ///< its steps were solved loosely
};

class OrbitSearch {
public:
  OrbitSearch(MeshMarch& march, const OrbitGuess& guess, const PeriodicOptions& options, const SearchObserver& observer)
      : march_(march),
        mesh_(march.mesh()),
        options_(options),
        observer_(observer),
        lead_(options.lead),
        jacobian_(guess.motion.freedoms(), mesh_.velocity_weight(), guess.monodromy) {
    const bool same_films =
        guess.neighbour && same_lattice(guess.neighbour->shape, march.discretisation()->grid().shape());
    set_loose(mesh_.inertia > 0.0 && (!same_films || guess.lead > 0.0));
    if (same_films && guess.lead > 0.0) {
      begin_with_lead(guess);
    } else if (same_films) {
      march_.resume(0.0, *guess.neighbour);
      march_.displace(guess.motion, time_to_follow);
    } else {
      march_.start(guess.motion);
    }
  }

  PeriodicOrbit run() {
    while (!march_period()) {
      if (best_will_do()) return orbit_of(*best_);
      if (stagnates()) throw not_found(periods_);
      place_next();
    }
    return orbit_of(last_);
  }

  OrbitGuess improved() {
    march_period();
    return {moved(last_.start.motion, 1.0, jacobian_.newton_step(last_.defect, largest_change)), jacobian_.monodromy(),
            last_.end};
  }

private:
  /// With films of another grid, which oil passes before the first period begins; with stationary ones, where that
  /// cannot be marched.
  void begin_with_lead(const OrbitGuess& guess) {
    try {
      march_.resume(mesh_.period() - guess.lead, *guess.neighbour);
      march_.adapt_pressures();
      march_.run(mesh_.period());
      lead_ = guess.lead;
      lead_map_ = guess.lead_map;
      trials_ = 1;
    } catch (const SolveError& error) {
      trouble_ = error.what();
      march_.start(guess.motion);
    }
  }

  PeriodicOrbit orbit_of(const Trial& trial) const {
    return {trial.start,       trial.end, trial.before,         beside_, trial.begin, mesh_.weighted_norm(trial.defect),
            trial.film_defect, periods_,  jacobian_.monodromy()};
  }

  bool best_will_do() const {
    constexpr double loosely = 4.0;
    return options_.enough_periods && periods_ >= *options_.enough_periods * mesh_.periods() && best_ &&
           !best_->loose && mesh_.weighted_norm(best_->defect) < loosely * options_.tolerance &&
           best_->film_defect < loosely * options_.film_tolerance;
  }

  /// Whether the best period so far has come nearer for the last time too long ago.
  bool stagnates() {
    const double now = distance(*best_);
    if (now < 0.5 * halved_) {
      halved_ = now;
      halved_at_ = periods_;
    }
    return options_.patience && periods_ - halved_at_ >= *options_.patience * mesh_.periods();
  }

  /// How far a period is from repeating, below 1 where it does. A motion may repeat by chance while films have yet to
  /// follow it.
  double distance(const Trial& trial) const {
    return std::max(mesh_.weighted_norm(trial.defect) / options_.tolerance,
                    trial.film_defect / options_.film_tolerance);
  }

  /// One period from where the march is; true if it repeats. A march that fails counts as a bad step, but for the
  /// first.
  bool march_period() {
    count_period();
    Trial trial{.start = march_.state(), .end = {}, .begin = march_.T()};
    const int halved_before = march_.halved_steps();
    trial.loose = loose_;
    try {
      trial.before = gearfilm::march_period(march_, lead_);
    } catch (const SolveError& error) {
      if (!best_) throw;
      trouble_ = error.what();
      better_ = false;
      return false;
    }
    trial.end = march_.state();
    trial.defect = difference(trial.end.motion, trial.start.motion);
    trial.film_defect =
        film_change(trial.start, trial.end, march_.comm(), mesh_.traction && mesh_.traction->heats_film());
    // The films of the first period were not made by a march: it says little about the map of the motion alone.
    const bool first_true = ++trials_ == 2;
    const Motion step = difference(trial.start.motion, last_.start.motion);
    if (trials_ > 2 && mesh_.weighted_norm(step) > telling_step) {
      jacobian_.update(step, difference(trial.end.motion, last_.end.motion));
    }
    const double change = mesh_.weighted_norm(trial.defect);
    better_ =
        !best_ || first_true || settling_ > 0 || change < options_.tolerance || distance(trial) < distance(*best_);
    last_ = trial;
    if (change > worth_keeping) beside_ = trial.end;
    if (better_) best_ = trial;
    const bool found = distance(trial) < 1.0 && !trial.loose;
    set_loose(loose_ && mesh_.weighted_norm(best_->defect) > far_off * options_.tolerance);
    observer_({periods_, trial.begin, change, trial.film_defect, found, march_.halved_steps() - halved_before});
    return found;
  }

  /// How steps are solved from now on, those that lead to a period too.
  void set_loose(bool loose) {
    loose_ = loose;
    march_.set_looseness(loose ? double(looseness) : 1.0);
  }

  /// Puts the march where the next period is to begin.
  void place_next() {
    if (settling_ > 0 && better_) {
      --settling_;
      return march_on();
    }
    settling_ = 0;
    shortening_ = better_ ? 1.0 : 0.5 * shortening_;
    if (better_) measured_ = false;
    for (; shortening_ >= shortest_step || !measured_; shortening_ *= 0.5) {
      try {
        if (shortening_ < shortest_step) measure_jacobian();
        begin_at(moved(best_->start.motion, shortening_, jacobian_.newton_step(best_->defect, largest_change)));
        return;
      } catch (const SolveError& error) {
        if (periods_ > options_.max_periods) throw;
        trouble_ = error.what();
      }
    }
    settling_ = settling_periods - 1;
    march_on();
  }

  /// A period at another motion, with the films of the best one's end.
  void begin_at(const Motion& motion) {
    const double begin = mesh_.next_period(march_.T());
    if (!lead_map_) {
      march_.resume(begin, best_->end);
      return march_.displace(motion, time_to_follow);
    }
    const double next = march_.T() > begin - lead_ ? begin + mesh_.period() : begin;
    march_.resume(next - lead_, *best_->before);
    march_.displace(moved(best_->before->motion, 1.0, preimage(*lead_map_, difference(motion, best_->end.motion))),
                    time_to_follow);
    march_.run(next);
    march_.displace(motion, time_to_follow);
  }

  void measure_jacobian() {
    measured_ = true;
    shortening_ = 1.0;
    march_.set_looseness(1.0);
    for (Eigen::Index k = 0; k < best_->defect.freedoms(); ++k) {
      measure(
          *best_, [k](Motion& step) -> double& { return step.q[k]; }, difference_step);
      measure(
          *best_, [k](Motion& step) -> double& { return step.v[k]; }, difference_step / mesh_.velocity_weight());
    }
    set_loose(loose_);
  }

  void march_on() {
    shortening_ = 1.0;
    measured_ = false;
    march_.resume(mesh_.next_period(march_.T()), best_->end);
  }

  /// One column of the Jacobian, by a period with a disturbed part of the motion.
  template <class Part>
  void measure(const Trial& base, Part part, double disturbance) {
    count_period();
    Motion step = Motion::zero(base.start.motion.freedoms());
    part(step) = disturbance;
    march_.resume(mesh_.next_period(march_.T()), base.start);
    march_.displace(moved(base.start.motion, 1.0, step));
    gearfilm::march_period(march_, lead_);
    const Motion change = difference(march_.motion(), base.end.motion);
    jacobian_.update(step, change);
  }

  void count_period() {
    periods_ += mesh_.periods();
    if (periods_ > options_.max_periods) throw not_found(options_.max_periods);
  }

  NoPeriodicState not_found(int periods) const {
    std::string left;
    if (best_) {
      left = worded(": (H0, V0) still changes by ", mesh_.weighted_norm(best_->defect), ", the films by ",
                    best_->film_defect);
    }
    if (!trouble_.empty()) left += " (on the way: " + trouble_ + ")";
    return NoPeriodicState(
        "no periodic state after ", periods, " mesh periods", left,
        "; allow more periods (periodic_max_periods) or come from a neighbouring speed (gearfilm sweep)");
  }

  MeshMarch& march_;
  const MeshModel& mesh_;
  PeriodicOptions options_;
  const SearchObserver& observer_;
  double lead_ = 0.0;
  std::optional<Monodromy> lead_map_;
  MapJacobian jacobian_;
  int periods_ = 0;
  bool loose_ = false;        ///< the next period, which will not repeat, need not be solved for to the last
  int trials_ = 0;            ///< periods marched to their end
  double halved_ = HUGE_VAL;  ///< the distance of the best period when it had halved for the last time
  int halved_at_ = 0;         ///< after so many mesh periods
  std::optional<PairState> beside_;
  Trial last_;
  std::optional<Trial> best_;
  bool better_ = true;       ///< the last trial improved on the best before it
  bool measured_ = false;    ///< the Jacobian was measured since the last improvement
  double shortening_ = 1.0;  ///< part of the Newton step taken
  int settling_ = 0;         ///< periods still to be marched on
  std::string trouble_;      ///< why the last failed march failed
};

}  // namespace

std::optional<PairState> march_period(MeshMarch& march, double lead) {
  const double end = march.T() + march.mesh().period();
  std::optional<PairState> before;
  if (lead > 0.0) {
    march.run(end - lead);
    before = march.state();
  }
  march.run(end);
  return before;
}

OrbitGuess guess_from(const DryOrbit& dry, double film_shift) {
  OrbitGuess guess{dry.start, dry.monodromy, {}};
  guess.motion.H0() += film_shift;
  return guess;
}

OrbitGuess improved_guess(MeshMarch& march, const OrbitGuess& guess, const SearchObserver& observer) {
  return OrbitSearch(march, guess, {}, observer).improved();
}

PeriodicOrbit find_periodic_orbit(MeshMarch& march, const OrbitGuess& guess, const PeriodicOptions& options,
                                  const SearchObserver& observer) {
  return OrbitSearch(march, guess, options, observer).run();
}

}  // namespace gearfilm
