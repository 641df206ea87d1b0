#include "app/branch_report.hpp"

#include <array>
#include <iomanip>
#include <sstream>

#include "output/screen.hpp"

namespace gearfilm {
namespace {

constexpr int parameter_digits = 7;  // of values of the parameter

std::string name_of(const Branch& branch) {
  return "branch " + std::to_string(branch.number) + " (order " + std::to_string(branch.order) + ")";
}

const char* meaning(PointKind kind) {
  constexpr std::array meanings = {
      "", "a multiplier is 1: the branch turns round", "a multiplier is -1: the period doubles",
      "a pair of multipliers on the unit circle: a second frequency is born", "the total force just reaches zero"};
  return meanings[static_cast<std::size_t>(kind)];
}

std::string place(const BranchState& state, const std::string& unit) {
  return worded(std::setprecision(parameter_digits), state.parameter, " ", unit, ", H0 ", std::setprecision(5),
                state.motion.H0(), ", V0 ", state.motion.V0());
}

}  // namespace

void BranchReport::add(const Branch& branch, PointKind kind, const BranchPoint& point) {
  if (every_point_ || kind != PointKind::regular) {
    print(branch, kind, point);
  } else {
    progress_.report(worded(name_of(branch), ": ", branch.points, " points, at ", std::setprecision(parameter_digits),
                            point.state.parameter, " ", unit_, ", force ratio ", std::setprecision(4),
                            point.value.largest_force));
  }
}

void BranchReport::print(const Branch& branch, PointKind kind, const BranchPoint& point) {
  const bool regular = kind == PointKind::regular;
  const std::string what = regular ? worded(std::setprecision(4), point.stable() ? "stable" : "unstable",
                                            ", largest multiplier ", largest_modulus(point.multipliers()))
                                   : meaning(kind);
  progress_.note(worded(name_of(branch), ": ", regular ? "" : gearfilm::name_of(kind), regular ? "" : " at ",
                        std::setprecision(parameter_digits), point.state.parameter, " ", unit_, ", force ratio ",
                        std::setprecision(4), point.value.largest_force, "; ", what));
}

void BranchReport::finish(const std::vector<Branch>& branches, const std::vector<Stretch>& stretches) {
  std::ostringstream table;
  table << "branch  order" << std::setw(14) << "from" << std::setw(14) << "to"
        << "  [" << unit_ << "]\n"
        << std::setprecision(parameter_digits);
  for (const Stretch& stretch : stretches) {
    table << std::setw(6) << stretch.branch << std::setw(7) << stretch.order << std::setw(14) << stretch.from
          << std::setw(14) << stretch.to << (stretch.stable ? "  stable" : "  unstable") << "\n";
  }
  std::string lines = table.str();
  lines.pop_back();
  progress_.note(lines);
  for (const Branch& branch : branches) {
    if (branch.end == BranchEnd::lost) {
      warn(comm_, name_of(branch) + " is lost at " + place(branch.last, unit_) +
                      ": no next point however short the step; lower continuation.smallest_step, or come from the "
                      "other end (continuation.from, and start.H0 with start.V0 for a state on it)");
    } else if (branch.end == BranchEnd::most_points) {
      warn(comm_, name_of(branch) + " ends at " + place(branch.last, unit_) + " after " +
                      std::to_string(branch.points) +
                      " points; raise continuation.points or "
                      "continuation.largest_step");
    }
  }
}

}  // namespace gearfilm
