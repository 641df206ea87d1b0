// A smooth function on an interval, as a Chebyshev series: round-off accuracy at the cost of an interpolation.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace gearfilm {

template <int terms>
class Chebyshev {
public:
  Chebyshev() = default;
  template <class Function>
  Chebyshev(double low, double high, Function function) : middle_(0.5 * (low + high)), half_range_(0.5 * (high - low)) {
    std::array<double, terms> values{};
    const auto angle = [](int node) { return std::numbers::pi * (node + 0.5) / terms; };
    for (int node = 0; node < terms; ++node) values[node] = function(middle_ + half_range_ * std::cos(angle(node)));
    for (int k = 0; k < terms; ++k) {
      for (int node = 0; node < terms; ++node) {
        coefficients_[k] += (k == 0 ? 1.0 : 2.0) / terms * values[node] * std::cos(k * angle(node));
      }
    }
  }

  /// Clenshaw's recurrence.
  double operator()(double at) const {
    const double x = (at - middle_) / half_range_;
    double after = 0.0, here = 0.0;
    for (int k = terms - 1; k > 0; --k) {
      const double before = coefficients_[k] + 2.0 * x * here - after;
      after = here;
      here = before;
    }
    return coefficients_[0] + x * here - after;
  }

private:
  double middle_ = 0.0;
  double half_range_ = 1.0;
  std::array<double, terms> coefficients_{};
};

}  // namespace gearfilm
