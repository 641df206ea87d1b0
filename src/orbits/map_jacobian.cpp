#include "orbits/map_jacobian.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/dense.hpp"

namespace gearfilm {

MapJacobian::MapJacobian(Eigen::Index freedoms, double velocity_worth, Monodromy monodromy)
    : worth_(velocity_worth), entries_(std::move(monodromy)) {
  if (entries_.size() == 0) entries_ = Monodromy::Zero(2 * freedoms, 2 * freedoms);
}

Motion MapJacobian::newton_step(const Motion& defect, double largest) const {
  const Eigen::Index size = entries_.rows();
  const Eigen::VectorXd step = solved(Monodromy::Identity(size, size) - entries_, to_vector(defect));
  const Motion whole = to_motion(step);
  const auto of_flanks = [&](const Motion& change) {
    return std::max(std::abs(change.H0()), worth_ * std::abs(change.V0()));
  };
  const double most = std::max(largest, of_flanks(defect));
  return moved(Motion::zero(whole.freedoms()), std::min(1.0, most / of_flanks(whole)), whole);
}

void MapJacobian::update(const Motion& step, const Motion& map_change) {
  const Eigen::VectorXd x = to_vector(step), dual = to_vector(weighted(step, worth_ * worth_));
  const double square = x.dot(dual);
  if (square == 0.0) return;
  entries_ += (to_vector(map_change) - entries_ * x) / square * dual.transpose();
}

}  // namespace gearfilm
