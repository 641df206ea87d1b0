#include "orbits/branch_point.hpp"

#include <cmath>
#include <utility>

#include "algebra/dense.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

/// The derivatives of P(x, lambda) - x in u.
Eigen::MatrixXd rows_of(const MapValue& value, double unit) {
  const Eigen::Index size = value.by_motion.rows();
  Eigen::MatrixXd rows(size, size + 1);
  rows << value.by_motion - Monodromy::Identity(size, size), unit * to_vector(value.by_parameter);
  return rows;
}

/// The direction orthogonal to one row less than there are columns; nothing where there are several.
std::optional<BranchVector> orthogonal_to(const Eigen::MatrixXd& rows) {
  const Eigen::MatrixXd directions = orthogonal_complement(rows.transpose());
  if (directions.cols() > 1) return {};
  return directions.col(0);
}

}  // namespace

bool BranchCorrector::finish(BranchPoint& point, const BranchVector& normal) const {
  try {
    if (point.value.measure) std::exchange(point.value.measure, {})(point.value);
  } catch (const SolveError&) {
    return false;
  }
  const std::optional<BranchVector> along = orthogonal_to(rows_of(point.value, options_.unit));
  if (!along) return false;
  point.tangent = std::copysign(1.0, along->dot(normal)) * *along;
  return true;
}

// A map that magnifies disturbances magnifies the noise of its image too: then it is the step that tells how near u is.
std::optional<BranchCorrector::Corrected> BranchCorrector::correct(const BranchVector& predicted,
                                                                   const BranchVector& normal) const {
  constexpr double farthest = 10.0;  // from the prediction: no orbit of that branch
  const double tolerance = options_.tolerance * order_;
  BranchVector u = predicted;
  for (int iteration = 0; iteration <= options_.most_iterations; ++iteration) {
    BranchPoint point;
    point.state = state(u);
    try {
      point.value = map_(point.state, order_);
    } catch (const SolveError&) {
      return {};
    }
    Eigen::MatrixXd equations(u.size(), u.size());
    equations << rows_of(point.value, options_.unit), normal.transpose();
    const Motion defect = difference(point.value.image(), point.state.motion);
    BranchVector right(u.size());
    right << -to_vector(defect), normal.dot(predicted - u);
    const BranchVector step = solved(equations, right);
    if (!step.allFinite()) return {};
    if (length(defect) < tolerance || step.norm() < tolerance) {
      if (!finish(point, normal)) return {};
      return Corrected{std::move(point), iteration};
    }
    u += step;
    if (!((u - predicted).norm() < farthest)) return {};
  }
  return {};
}

std::optional<BranchCorrector::Corrected> BranchCorrector::at_parameter(const BranchState& guess) const {
  const BranchVector u = coordinates(guess);
  return correct(u, BranchVector::Unit(u.size(), u.size() - 1));
}

}  // namespace gearfilm
