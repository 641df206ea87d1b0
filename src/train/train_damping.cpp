#include "train/train_damping.hpp"

#include <algorithm>
#include <array>

namespace gearfilm {

std::vector<ReferenceFrequency> damp_elements(Train& train, const std::vector<TrainMode>& modes) {
  std::vector<ReferenceFrequency> references;
  for (std::size_t k = 0; k < train.elements().size(); ++k) {
    const TrainElement& element = train.elements()[k];
    if (!element.damping_ratio) continue;
    const auto share = [k](const TrainMode& mode) { return mode.element_shares[k]; };
    const TrainMode& largest = *std::ranges::max_element(modes, {}, share);
    train.set_damping(k, *element.damping_ratio / largest.rate * (element.stiffness + element.stiffness.transpose()));
    references.push_back({element.name, largest.frequency()});
  }
  return references;
}

Eigen::MatrixXd modal_damping(const Train& train, const std::vector<TrainMode>& modes, double damping_ratio) {
  Eigen::MatrixXd damping = Eigen::MatrixXd::Zero(train.freedoms(), train.freedoms());
  for (const TrainMode& mode : modes) {
    const Eigen::VectorXd momentum = train.mass() * mode.shape;
    damping += 2.0 * damping_ratio * mode.rate * (1.0 - mode.mesh_share) * momentum * momentum.transpose();
  }
  return damping;
}

DampedTrain damped_train(Train train, const ContactSpring& contact, double damping_ratio) {
  RelativeMotion relative = relative_motion(train);
  std::vector<TrainMode> modes = train_modes(train, relative, std::array{contact.stiffness});
  std::vector<ReferenceFrequency> references = damp_elements(train, modes);
  const Eigen::MatrixXd damping = train.damping() + modal_damping(train, modes, damping_ratio) +
                                  contact.damping * train.contacts().transpose() * train.contacts();
  return {std::move(train), std::move(relative), std::move(modes), std::move(references), damping};
}

}  // namespace gearfilm
