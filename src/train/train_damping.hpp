// Damping of a drive train beside that of the films: by element, and by mode.
//
//   an element with a ratio zeta_e    c = 2 zeta_e k/w_e ,  w_e that of the mode with the element's largest share
//   all modes, zeta                   C = M V diag(2 zeta w_i (1 - s_i)) V^T M ,  s_i the contacts' share of mode i
//   beside dry contacts               c_p B_p^T B_p
// The contacts' share is left to films, or to the damper beside dry contacts. V has no rotation of the whole: none of
// these damps it. Assumption: the ratio of an element is exact at w_e alone; no loss factor is independent of frequency
// in time.
#pragma once

#include "train/train_modes.hpp"

namespace gearfilm {

/// Where the ratio of an element was made a damper.
struct ReferenceFrequency {
  std::string element;
  double frequency = 0.0;  ///< w_e/(2 pi) [Hz]
};

/// Gives the elements with a ratio their dampers, by the undamped modes.
std::vector<ReferenceFrequency> damp_elements(Train& train, const std::vector<TrainMode>& modes);

/// C of one ratio for all modes.
Eigen::MatrixXd modal_damping(const Train& train, const std::vector<TrainMode>& modes, double damping_ratio);

/// A drive train whose one contact is a spring k [N/m] with a damper c [N s/m] beside it.
struct DampedTrain {
  Train train;
  RelativeMotion relative;
  std::vector<TrainMode> modes;  ///< undamped
  std::vector<ReferenceFrequency> references{};
  Eigen::MatrixXd damping{};  ///< C, that of the contact included

  double damping_ratio(const TrainMode& mode) const { return mode.damping_ratio(damping); }
};

struct ContactSpring {
  double stiffness = 0.0, damping = 0.0;
};

/// damping_ratio: of all modes. Throws InputError for parts that hang on nothing.
DampedTrain damped_train(Train train, const ContactSpring& contact, double damping_ratio);

}  // namespace gearfilm
