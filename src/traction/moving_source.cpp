#include "traction/moving_source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lubricant/independent_iterations.hpp"

namespace gearfilm {

double HeatedBody::effusivity() const { return std::sqrt(conductivity * density * heat_capacity); }

MovingSource::MovingSource(int lines, double h_x) : weights_(lines) {
  const auto power = [](double n) { return n * std::sqrt(n); };
  const double scale = 4.0 / 3.0 * std::sqrt(h_x);
  weights_[0] = scale;
  for (int n = 1; n < lines; ++n) weights_[n] = scale * (power(n + 1.0) - 2.0 * power(n) + power(n - 1.0));
}

void MovingSource::earlier(const std::vector<double>& heat, int i, std::vector<double>& sums) const {
  const std::size_t rows = sums.size();
  std::ranges::fill(sums, 0.0);
  double* sum = sums.data();
  // Four lines at once: sums are loaded and stored a quarter as often.
  for (int m = i % 4; m < i; m += 4) {
    const double *weight = &weights_[i - m], *line = heat.data() + m * rows;
    const double *second = line + rows, *third = second + rows, *fourth = third + rows;
    GEARFILM_INDEPENDENT_ITERATIONS
    for (std::size_t j = 0; j < rows; ++j) {
      sum[j] += weight[0] * line[j] + weight[-1] * second[j] + weight[-2] * third[j] + weight[-3] * fourth[j];
    }
  }
  for (int m = 0; m < i % 4; ++m) {
    const double weight = weights_[i - m], *line = heat.data() + m * rows;
    GEARFILM_INDEPENDENT_ITERATIONS
    for (std::size_t j = 0; j < rows; ++j) sum[j] += weight * line[j];
  }
}

double surface_response(const HeatedBody& body, double velocity) {
  return 1.0 / (body.effusivity() * std::sqrt(std::numbers::pi * velocity));
}

}  // namespace gearfilm
