#include "gearfilm/orbits/branch_point.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

/// The derivatives of P(x, lambda) - x in u.
Eigen::Matrix<double, 2, 3> rows_of(const MapValue& value, double unit) {
  Eigen::Matrix<double, 2, 3> rows;
  rows << value.by_motion - Monodromy::Identity(), unit * to_vector(value.by_parameter);
  return rows;
}

}  // namespace

bool BranchCorrector::finish(BranchPoint& point, const BranchVector& normal) const {
  try {
    if (point.value.measure) std::exchange(point.value.measure, {})(point.value);
  } catch (const SolveError&) {
    return false;
  }
  const auto rows = rows_of(point.value, options_.unit);
  const BranchVector along = rows.row(0).cross(rows.row(1));
  const double size = std::copysign(along.norm(), along.dot(normal));
  if (size == 0.0) return false;
  point.tangent = along / size;
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
    Eigen::Matrix3d equations;
    equations << rows_of(point.value, options_.unit), normal.transpose();
    const Eigen::PartialPivLU<Eigen::Matrix3d> factors(equations);
    if (factors.determinant() == 0.0) return {};
    const Motion defect = difference(point.value.image(), point.state.motion);
    const BranchVector step = factors.solve(BranchVector(-defect.H0, -defect.V0, normal.dot(predicted - u)));
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
  return correct(coordinates(guess), {0.0, 0.0, 1.0});
}

}  // namespace gearfilm
