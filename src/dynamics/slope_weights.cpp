#include "dynamics/slope_weights.hpp"

namespace gearfilm {

std::vector<double> slope_weights(const std::vector<double>& times) {
  std::vector<double> weights(times.size(), 0.0);
  for (std::size_t j = 1; j < times.size(); ++j) weights[0] += 1.0 / (times[0] - times[j]);
  for (std::size_t n = 1; n < times.size(); ++n) {
    weights[n] = 1.0 / (times[n] - times[0]);
    for (std::size_t j = 1; j < times.size(); ++j) {
      if (j != n) weights[n] *= (times[0] - times[j]) / (times[n] - times[j]);
    }
  }
  return weights;
}

std::complex<double> slope_of_oscillation(double w, const std::vector<double>& times) {
  const std::vector<double> weights = slope_weights(times);
  std::complex<double> slope = 0.0;
  for (std::size_t n = 0; n < times.size(); ++n) slope += weights[n] * std::polar(1.0, -w * (times[0] - times[n]));
  return slope;
}

}  // namespace gearfilm
