#include "roughness/asperity_law.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "roughness/height_integrals.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

constexpr int table_points = 241;
constexpr double first_z = -6.0, last_z = 6.0, step_z = (last_z - first_z) / (table_points - 1);
constexpr double largest_exponent = 300.0;

/// The plane of the summits, in units of sigma.
struct Summits {
  explicit Summits(const AsperityOptions& options) {
    if (!options.summit_shift) return;
    const double product = options.density_product;
    height = 0.045944 / product;
    deviation = std::sqrt(1.0 - 3.717e-4 / (product * product));
  }

  double height = 0.0;     ///< y_s/sigma
  double deviation = 1.0;  ///< sigma_s/sigma
  double at(double z) const { return (z - height) / deviation; }
};

/// The load of an asperity over its radius squared, by d/beta.
class AsperityLoad {
public:
  AsperityLoad(double hardness, double modulus) : hardness_(hardness), modulus_(modulus) {
    const double root = 3.0 * pi * first_yield * hardness / (4.0 * modulus);
    elastic_ = root * root;
    plastic_ = 54.0 * elastic_;
  }

  double operator()(double d) const {
    if (d <= elastic_) return 4.0 / 3.0 * modulus_ * d * std::sqrt(d);
    if (d >= plastic_) return area(d) * hardness_;
    return area(d) * hardness_ * (1.0 - (1.0 - first_yield) * std::log(plastic_ / d) / std::log(plastic_ / elastic_));
  }
  /// On which it rests, over the radius squared.
  double area(double d) const {
    const double t = std::clamp((d - elastic_) / (plastic_ - elastic_), 0.0, 1.0);
    return pi * d * (1.0 - 2.0 * t * t * t + 3.0 * t * t);
  }
  double elastic() const { return elastic_; }
  double plastic() const { return plastic_; }

private:
  static constexpr double first_yield = 0.4;  // k
  double hardness_, modulus_, elastic_, plastic_;
};

/// Int_from^to f(x) dx by Simpson's rule, with nodes close to `from`, where f may begin with a root.
double integral_from(double from, double to, const std::function<double(double)>& f) {
  if (!(to > from)) return 0.0;
  constexpr int panels = 400;
  const double step = std::sqrt(to - from) / panels;
  double sum = 0.0;
  for (int k = 1; k <= panels; ++k) {
    const double t = k * step, weight = k == panels ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0);
    sum += weight * 2.0 * t * f(from + t * t);
  }
  return sum * step / 3.0;
}

/// n beta^2 Int f(d/beta) over the summits' heights, f a value of one asperity by how far it is pressed in.
template <class OfAsperity>
double over_summits(const AsperityOptions& options, const AsperityLoad& load, double z, OfAsperity of) {
  const Summits summits(options);
  const double depth_unit = options.slope * summits.deviation;  // of d/beta, by s
  const double u = summits.at(z);
  const double last = std::max(u, 0.0) + 9.0 + std::max(0.0, -u);
  const auto part = [&](double s) { return of(depth_unit * (s - u)) * std::exp(-0.5 * s * s) / std::sqrt(2.0 * pi); };
  const double first_yield = std::min(u + load.elastic() / depth_unit, last),
               full_yield = std::min(u + load.plastic() / depth_unit, last);
  const double sum = integral_from(u, first_yield, part) + integral_from(first_yield, full_yield, part) +
                     integral_from(full_yield, last, part);
  // n beta^2 = (n beta sigma)/(sigma/beta)
  return options.density_product / options.slope * sum;
}

double zhao_maietta_chang(const AsperityOptions& options, double modulus, double z) {
  const AsperityLoad load(options.hardness, modulus);
  return over_summits(options, load, z, load);
}

double greenwood(const AsperityOptions& options, double modulus, double z) {
  const Summits summits(options);
  const double product = options.density_product * summits.deviation,
               root = std::sqrt(options.slope * summits.deviation), u = summits.at(z);
  if (options.kind == AsperityLawKind::greenwood_tripp) {
    return 16.0 * std::numbers::sqrt2 * pi / 15.0 * product * product * root * modulus * height_integral(2.5, u);
  }
  return 4.0 / 3.0 * product * root * modulus * height_integral(1.5, u);
}

/// Slopes of a cubic spline with continuous curvature through values at equal distances; at its ends those of the
/// parabolas through three of them.
std::vector<double> spline_slopes(const std::vector<double>& y, double step) {
  const std::size_t n = y.size();
  std::vector<double> slope(n), above(n, 0.0);
  slope[0] = (-1.5 * y[0] + 2.0 * y[1] - 0.5 * y[2]) / step;
  slope[n - 1] = (1.5 * y[n - 1] - 2.0 * y[n - 2] + 0.5 * y[n - 3]) / step;
  const double last = slope[n - 1];
  // m_(k-1) + 4 m_k + m_(k+1) = 3 (y_(k+1) - y_(k-1))/step
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double pivot = 4.0 - above[k - 1];
    above[k] = 1.0 / pivot;
    slope[k] = (3.0 * (y[k + 1] - y[k - 1]) / step - slope[k - 1]) / pivot;
  }
  slope[n - 1] = last;
  for (std::size_t k = n - 1; k-- > 1;) slope[k] -= above[k] * slope[k + 1];
  return slope;
}

/// ln p of the user's table at z: monotone cubic (Fritsch and Carlson), straight beyond its ends.
double tabulated(const AsperityOptions& options, double z) {
  const std::vector<double>& x = options.table_z;
  const std::size_t n = x.size();
  const auto y = [&](std::size_t k) { return std::log(options.table_p[k]); };
  const auto chord = [&](std::size_t k) { return (y(k + 1) - y(k)) / (x[k + 1] - x[k]); };
  const auto slope = [&](std::size_t k) {
    if (k == 0) return chord(0);
    if (k == n - 1) return chord(n - 2);
    const double a = chord(k - 1), b = chord(k);
    return 2.0 * a * b / (a + b);
  };
  if (z <= x.front()) return y(0) + slope(0) * (z - x.front());
  if (z >= x.back()) return y(n - 1) + slope(n - 1) * (z - x.back());
  const auto k = static_cast<std::size_t>(std::ranges::upper_bound(x, z) - x.begin()) - 1;
  const double h = x[k + 1] - x[k], t = (z - x[k]) / h;
  return y(k) * (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) + y(k + 1) * t * t * (3.0 - 2.0 * t) +
         h * (slope(k) * t * (1.0 - t) * (1.0 - t) - slope(k + 1) * t * t * (1.0 - t));
}

double log_of_law(const AsperityOptions& options, double modulus, double z) {
  switch (options.kind) {
    case AsperityLawKind::greenwood_tripp:
    case AsperityLawKind::greenwood_williamson:
      return std::log(greenwood(options, modulus, z));
    case AsperityLawKind::zhao_maietta_chang:
      return std::log(zhao_maietta_chang(options, modulus, z));
    case AsperityLawKind::exponential:
      return std::log(options.exponential_pressure) - z / options.exponential_gap;
    case AsperityLawKind::table:
      return tabulated(options, z);
  }
  return 0.0;
}

}  // namespace

AsperityLaw::AsperityLaw(const AsperityOptions& options, double reduced_modulus)
    : options_(options), modulus_(0.5 * reduced_modulus) {
  for (int k = 0; k < table_points; ++k) value_.push_back(log_of_law(options, modulus_, first_z + k * step_z));
  slope_ = spline_slopes(value_, step_z);
}

double AsperityLaw::log_pressure(double z, double& slope) const {
  if (z <= first_z || z >= last_z) {
    const bool low = z <= first_z;
    slope = low ? slope_.front() : slope_.back();
    return (low ? value_.front() : value_.back()) + slope * (z - (low ? first_z : last_z));
  }
  const double place = (z - first_z) / step_z;
  const auto k = std::min(static_cast<std::size_t>(place), value_.size() - 2);
  const double t = place - static_cast<double>(k), rest = 1.0 - t;
  const double rise = value_[k + 1] - value_[k], m_0 = step_z * slope_[k], m_1 = step_z * slope_[k + 1];
  slope = (6.0 * t * rest * rise + m_0 * rest * (1.0 - 3.0 * t) + m_1 * t * (3.0 * t - 2.0)) / step_z;
  return value_[k] + rise * t * t * (3.0 - 2.0 * t) + m_0 * t * rest * rest - m_1 * t * t * rest;
}

AsperityLaw::Value AsperityLaw::operator()(double z) const {
  double slope = 0.0;
  const double pressure = std::exp(std::min(log_pressure(z, slope), largest_exponent));
  return {pressure, pressure * slope};
}

bool AsperityLaw::knows_real_area() const {
  return options_.kind != AsperityLawKind::exponential && options_.kind != AsperityLawKind::table;
}

std::optional<double> AsperityLaw::real_area(double z) const {
  if (!knows_real_area()) return {};
  const Summits summits(options_);
  const double product = pi * options_.density_product * summits.deviation;
  double part = 0.0;
  if (options_.kind == AsperityLawKind::greenwood_tripp) {
    part = product * product * height_integral(2.0, summits.at(z));
  } else if (options_.kind == AsperityLawKind::greenwood_williamson) {
    part = product * height_integral(1.0, summits.at(z));
  } else {
    const AsperityLoad load(options_.hardness, modulus_);
    part = over_summits(options_, load, z, [&](double d) { return load.area(d); });
  }
  return std::min(part, 1.0);
}

double AsperityLaw::gap_under(double pressure) const {
  const double wanted = std::log(pressure);
  double low = -1e4, high = 1e4, slope = 0.0;
  for (int n = 0; n < 100; ++n) {
    const double middle = 0.5 * (low + high);
    (log_pressure(middle, slope) > wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace gearfilm
