#include "gearfilm/dynamics/periodic_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

constexpr double multiplier_difference =
    2e-3;                               // of the motion: well above the noise of a march, within its linear range
constexpr double largest_change = 0.5;  // of H_0 or V_0 in one Newton step

double length(const Motion& motion) { return std::max(std::abs(motion.H0), std::abs(motion.V0)); }
Motion difference(const Motion& a, const Motion& b) { return {a.H0 - b.H0, a.V0 - b.V0}; }

/// Approximate Jacobian of the defect, map(x) - x, kept good by Broyden's update.
class DefectJacobian {
public:
  explicit DefectJacobian(const Monodromy& monodromy) : entries_(monodromy) {
    entries_[0][0] -= 1.0;
    entries_[1][1] -= 1.0;
  }
  /// -J^-1 defect.
  Motion newton_step(const Motion& defect) const {
    const auto& [first, second] = entries_;
    const double determinant = first[0] * second[1] - first[1] * second[0];
    Motion step{-(second[1] * defect.H0 - first[1] * defect.V0) / determinant,
                -(first[0] * defect.V0 - second[0] * defect.H0) / determinant};
    const double shrink = std::min(1.0, largest_change / length(step));
    return {shrink * step.H0, shrink * step.V0};
  }
  void update(const Motion& step, const Motion& defect_change) {
    const double square = step.H0 * step.H0 + step.V0 * step.V0;
    if (square == 0.0) return;
    const auto correct = [&](std::array<double, 2>& row, double change) {
      const double error = (change - row[0] * step.H0 - row[1] * step.V0) / square;
      row[0] += error * step.H0;
      row[1] += error * step.V0;
    };
    correct(entries_[0], defect_change.H0);
    correct(entries_[1], defect_change.V0);
  }

private:
  Monodromy entries_;
};

/// Largest change of any pressure between two states with the same contacts.
double film_change(const PairState& before, const PairState& after, MPI_Comm comm) {
  double largest = 0.0;
  for (std::size_t k = 0; k < before.films.size() && k < after.films.size(); ++k) {
    const std::vector<double>&first = before.films[k].pressure, &second = after.films[k].pressure;
    for (std::size_t n = 0; n < first.size(); ++n) largest = std::max(largest, std::abs(second[n] - first[n]));
  }
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, comm);
  return largest;
}

/// Marches one period.
PairState one_period(MeshMarch& march, const ContactPath& path) {
  march.run(march.T() + path.mesh_period());
  return march.state();
}

Monodromy measure_monodromy(MeshMarch& march, const ContactPath& path, const PairState& start, const PairState& end) {
  Monodromy monodromy{};
  for (int column = 0; column < 2; ++column) {
    Motion disturbed = start.motion;
    (column == 0 ? disturbed.H0 : disturbed.V0) += multiplier_difference;
    march.set_state(start);
    march.displace(disturbed);
    const Motion change = difference(one_period(march, path).motion, end.motion);
    monodromy[0][column] = change.H0 / multiplier_difference;
    monodromy[1][column] = change.V0 / multiplier_difference;
  }
  return monodromy;
}

}  // namespace

PeriodicOrbit find_periodic_orbit(MeshMarch& march, const ContactPath& path, const DryOrbit& dry, double film_shift,
                                  const PeriodicOptions& options, const SearchObserver& observer) {
  PeriodicOrbit orbit;
  orbit.dry = dry;
  march.start(Motion{dry.start.H0 + film_shift, dry.start.V0});
  DefectJacobian jacobian(dry.monodromy);
  PairState start = march.state();
  Motion step{}, last_defect{};
  double best = HUGE_VAL, damping = 1.0;
  for (int period = 1; period <= options.max_periods; ++period) {
    orbit.begin = march.T();
    const PairState end = one_period(march, path);
    const Motion defect = difference(end.motion, start.motion);
    if (period > 1) jacobian.update(step, difference(defect, last_defect));
    orbit.periods_used = period;
    orbit.start = start;
    orbit.defect = length(defect);
    orbit.film_defect = film_change(start, end, march.comm());
    observer({period, start.motion, end.motion, orbit.film_defect});
    if (orbit.defect < options.tolerance && orbit.film_defect < options.film_tolerance) {
      if (options.with_multipliers) orbit.monodromy = measure_monodromy(march, path, start, end);
      return orbit;
    }
    damping = orbit.defect < best ? 1.0 : 0.5 * damping;
    best = std::min(best, orbit.defect);
    step = jacobian.newton_step(defect);
    if (damping < 0.2) {
      step = defect;  // the map itself: marching on
      damping = 1.0;
    } else {
      step = {damping * step.H0, damping * step.V0};
    }
    last_defect = defect;
    march.displace({start.motion.H0 + step.H0, start.motion.V0 + step.V0});
    start = march.state();
  }
  std::ostringstream message;
  message << "no periodic state after " << options.max_periods << " mesh periods: (H0, V0) still changes by "
          << orbit.defect << ", the films by " << orbit.film_defect
          << "; allow more periods (periodic_max_periods) or start from a neighbouring speed";
  throw SolveError(message.str());
}

}  // namespace gearfilm
