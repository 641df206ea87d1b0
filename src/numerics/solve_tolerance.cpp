#include "numerics/solve_tolerance.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<double> of_curvature("newton_of_curvature", 0.3,
                                 "part of what curvature brings back that a linear solve may leave");
const Tuned<double> left_over("newton_left_over", 0.5, "part of Newton's tolerance that a linear solve may leave");
const Tuned<double> loosest_last("newton_loosest_solve", 0.2, "loosest relative tolerance of the last linear solves");

}  // namespace

double SolveTolerance::next(int iteration, double norm, double linear, double aim) {
  std::optional<double> curvature = first_;
  if (iteration > 0) curvature = std::sqrt(std::max(0.0, norm * norm - linear * linear)) / (before_ * before_);
  if (iteration == 1) first_ = curvature;
  before_ = norm;
  const double needed = left_over * aim / norm;
  const double wanted =
      curvature ? std::clamp(of_curvature * *curvature * norm, bounds_.tightest, bounds_.loosest) : bounds_.loosest;
  return std::clamp(needed, wanted, std::max<double>(wanted, loosest_last));
}

}  // namespace gearfilm
