// Undamped natural modes of a drive train whose contacts are springs.
//
//   (K + sum_p k_p B_p^T B_p) v = w^2 M v ,     v^T M v = 1
// in the relative coordinates (relative_motion.hpp), so that the rotation of the whole is no mode. Of an element whose
// stiffness is not symmetric (plain bearings) modes have the symmetric part, which alone stores energy.
//   share of a contact p      k_p (B_p v)^2/w^2 ;   of an element  (G v)^T k (G v)/w^2 ;   all of them add up to 1
#pragma once

#include <span>

#include "train/relative_motion.hpp"

namespace gearfilm {

struct TrainMode {
  double rate = 0.0;                   ///< w [rad/s]
  Eigen::VectorXd shape;               ///< v
  double mesh_share = 0.0;             ///< of all contacts together
  std::vector<double> element_shares;  ///< in the order of the train's elements

  double frequency() const;  ///< [Hz]
  /// Damping ratio by the damping C, where it is small: v^T C v/(2 w).
  double damping_ratio(const Eigen::MatrixXd& damping) const { return shape.dot(damping * shape) / (2.0 * rate); }
};

/// Lowest first; stiffness: k_p of each contact [N/m].
std::vector<TrainMode> train_modes(const Train& train, const RelativeMotion& relative,
                                   std::span<const double> stiffness);

/// v as lengths, its largest entry 1.
Eigen::VectorXd normalised_shape(const Train& train, const TrainMode& mode);

}  // namespace gearfilm
