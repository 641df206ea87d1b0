#include "mesh/held_modes.hpp"

#include <Eigen/Dense>

namespace gearfilm {
namespace {

constexpr double slow = 1.0 / 200.0;   // of the mesh frequency
constexpr double unfelt_share = 1e-3;  // of the mesh

/// W: a basis of z with `rows` z = 0, whose first motion alone has y_1, and that is 1 there.
Eigen::MatrixXd motions_beside(const Eigen::MatrixXd& rows) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> all(rows.transpose());
  const Eigen::MatrixXd whole = all.householderQ();
  const Eigen::MatrixXd beside = whole.rightCols(rows.cols() - rows.rows());
  const Eigen::HouseholderQR<Eigen::VectorXd> first(beside.row(0).transpose());
  Eigen::MatrixXd basis = beside * Eigen::MatrixXd(first.householderQ());
  basis.col(0) /= basis(0, 0);
  return basis;
}

}  // namespace

HeldModes hold_slow_modes(const std::shared_ptr<const MeshTrain>& train, double mesh_frequency) {
  if (!train || !train->ripples.empty()) return {train, {}};
  const DampedTrain& damped = *train->whole.damped;
  const Eigen::MatrixXd momentum = damped.train.mass() * train->whole.motions;
  std::vector<double> frequencies;
  Eigen::MatrixXd rows(0, train->freedoms());
  for (const TrainMode& mode : damped.modes) {
    if (mode.frequency() >= slow * mesh_frequency || mode.mesh_share > unfelt_share) continue;
    const Eigen::RowVectorXd row = mode.shape.transpose() * momentum;
    // Modes that no force reaches do not take part anyhow.
    constexpr double round_off = 1e-9;
    if (row.norm() <= round_off * momentum.norm() * mode.shape.norm()) continue;
    rows.conservativeResize(rows.rows() + 1, Eigen::NoChange);
    rows.bottomRows(1) = row.normalized();
    frequencies.push_back(mode.frequency());
  }
  if (frequencies.empty()) return {train, {}};
  const Eigen::MatrixXd W = motions_beside(rows), mass = W.transpose() * train->mass * W;
  const Eigen::MatrixXd accelerations = mass.partialPivLu().solve(W.transpose() * train->mass);
  MeshTrain held{.mass = mass,
                 .by_force = accelerations * train->by_force,
                 .by_back_force = accelerations * train->by_back_force,
                 .by_displacement = accelerations * train->by_displacement * W,
                 .by_velocity = accelerations * train->by_velocity * W,
                 .back = train->back * W,
                 .friction = train->friction * W,
                 .whole = train->whole};
  if (train->by_run_up.size() > 0) held.by_run_up = accelerations * train->by_run_up;
  held.whole.motions = train->whole.motions * W;
  return {std::make_shared<const MeshTrain>(std::move(held)), std::move(frequencies)};
}

}  // namespace gearfilm
