#include "dynamics/frequency_fit.hpp"

#include <algorithm>
#include <vector>

namespace gearfilm {

FrequencyFit frequency_fit(double w, std::complex<double> D) {
  if (w == 0.0) return {};
  const double x = D.imag() / w, y = D.real(), square = w * w * x;
  return {.alpha = y / square, .beta = x + y * y / square, .inertia = 1.0 / x, .damping = -y / x};
}

ModalFit::ModalFit(const Swings& swings, const std::function<FrequencyFit(double w)>& fit_of) {
  std::vector<FrequencyFit> fits;
  for (const double w : swings.rates) fits.push_back(fit_of(w));
  const auto matrix = [&](double FrequencyFit::*part) -> Eigen::MatrixXd {
    Eigen::VectorXd diagonal(swings.rates.size());
    std::ranges::transform(fits, diagonal.begin(), [part](const FrequencyFit& fit) { return fit.*part; });
    return swings.shapes * diagonal.asDiagonal() * swings.coordinates;
  };
  alpha = matrix(&FrequencyFit::alpha);
  beta = matrix(&FrequencyFit::beta);
  inertia = matrix(&FrequencyFit::inertia);
  damping = matrix(&FrequencyFit::damping);
}

BodyEquations fitted(BodyEquations motion, const ModalFit& fit) {
  const Eigen::Index n = fit.alpha.rows();
  const Eigen::MatrixXd inertia = motion.mass.bottomRightCorner(n, n);
  motion.mass.topRightCorner(n, n) = fit.alpha;
  motion.stiffness.topRightCorner(n, n) = -fit.beta;
  motion.mass.bottomRightCorner(n, n) = inertia * fit.inertia;
  motion.stiffness.bottomRightCorner(n, n) += inertia * fit.damping;
  return motion;
}

}  // namespace gearfilm
