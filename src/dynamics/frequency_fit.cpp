#include "dynamics/frequency_fit.hpp"

namespace gearfilm {

using namespace std::complex_literals;

std::complex<double> derivative_by_bdf1(double w, double dT) { return (1.0 - std::exp(-1i * w * dT)) / dT; }

std::complex<double> derivative_by_bdf2(double w, double dT, double dT_before) {
  const double ratio = dT / dT_before;
  return ((1.0 + 2.0 * ratio) / (1.0 + ratio) - (1.0 + ratio) * std::exp(-1i * w * dT) +
          ratio * ratio / (1.0 + ratio) * std::exp(-1i * w * (dT + dT_before))) /
         dT;
}

FrequencyFit frequency_fit(double w, std::complex<double> D) {
  if (w == 0.0) return {};
  const double x = D.imag() / w, y = D.real(), square = w * w * x;
  return {.alpha = y / square, .beta = x + y * y / square, .inertia = 1.0 / x, .damping = -y / x};
}

BodyEquations fitted(BodyEquations motion, const FrequencyFit& fit) {
  const double inertia = motion.mass(1, 1);
  motion.mass(0, 1) = fit.alpha;
  motion.stiffness(0, 1) = -fit.beta;
  motion.mass(1, 1) = fit.inertia * inertia;
  motion.stiffness(1, 1) = fit.damping * inertia;
  return motion;
}

}  // namespace gearfilm
