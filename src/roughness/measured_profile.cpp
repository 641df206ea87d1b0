#include "roughness/measured_profile.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearfilm {
namespace {

constexpr int points_in_cutoff = 12;

/// The heights at equal distances, straight between the points.
HeightProfile at_equal_steps(const std::vector<std::pair<double, double>>& points, double longest) {
  const double begin = points.front().first, length = points.back().first - begin;
  const double mean = length / static_cast<double>(points.size() - 1);
  const auto cells = static_cast<std::size_t>(std::ceil(length / std::min(mean, longest) - 1e-9));
  HeightProfile profile{begin, length / static_cast<double>(cells), {}};
  std::size_t next = 1;
  for (std::size_t k = 0; k <= cells; ++k) {
    const double s = begin + static_cast<double>(k) * profile.step;
    while (next + 1 < points.size() && points[next].first < s) ++next;
    const auto& [s_0, z_0] = points[next - 1];
    const auto& [s_1, z_1] = points[next];
    profile.heights.push_back(z_0 + (z_1 - z_0) * std::min(1.0, (s - s_0) / (s_1 - s_0)));
  }
  return profile;
}

/// Takes the parabola of least squares off; how deep it is.
double take_form_off(std::vector<double>& heights) {
  const auto count = static_cast<Eigen::Index>(heights.size());
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(count, -1.0, 1.0);
  Eigen::MatrixXd powers(count, 3);
  powers << Eigen::VectorXd::Ones(count), v, v.cwiseAbs2();
  Eigen::Map<Eigen::VectorXd> z(heights.data(), count);
  const Eigen::Vector3d form = (powers.transpose() * powers).ldlt().solve(powers.transpose() * z);
  z -= powers * form;
  return std::abs(form[2]);
}

std::vector<double> filtered(const HeightProfile& profile, double cutoff) {
  const double width = std::sqrt(std::numbers::ln2 / std::numbers::pi) * cutoff;
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(1.5 * width / profile.step));
  const auto count = static_cast<std::ptrdiff_t>(profile.heights.size());
  std::vector<double> weights, result;
  for (std::ptrdiff_t n = 0; n <= reach; ++n)
    weights.push_back(std::exp(-std::numbers::pi * std::pow(static_cast<double>(n) * profile.step / width, 2)));
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    double sum = 0.0, norm = 0.0;
    for (std::ptrdiff_t n = std::max(-reach, -k); n <= std::min(reach, count - 1 - k); ++n) {
      const double weight = weights[static_cast<std::size_t>(std::abs(n))];
      sum += weight * profile.heights[static_cast<std::size_t>(k + n)];
      norm += weight;
    }
    result.push_back(sum / norm);
  }
  return result;
}

double root_mean_square(const std::vector<double>& heights) {
  const Eigen::Map<const Eigen::VectorXd> z(heights.data(), static_cast<Eigen::Index>(heights.size()));
  return std::sqrt(z.squaredNorm() / static_cast<double>(z.size()));
}

void fade_ends(HeightProfile& profile, double length) {
  const auto count = static_cast<std::ptrdiff_t>(profile.heights.size());
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const double from_end = static_cast<double>(std::min(k, count - 1 - k)) * profile.step;
    if (from_end >= length) continue;
    profile.heights[static_cast<std::size_t>(k)] *= 0.5 * (1.0 - std::cos(std::numbers::pi * from_end / length));
  }
}

}  // namespace

SplitProfile split_profile(const std::vector<std::pair<double, double>>& points, double cutoff) {
  SplitProfile split{.resolved = at_equal_steps(points, cutoff / points_in_cutoff)};
  std::vector<double>& heights = split.resolved.heights;
  split.form = take_form_off(heights);
  split.rms = root_mean_square(heights);
  std::vector<double> shorter = heights;
  heights = filtered(split.resolved, cutoff);
  for (std::size_t k = 0; k < shorter.size(); ++k) shorter[k] -= heights[k];
  split.shorter_rms = root_mean_square(shorter);
  split.resolved_rms = root_mean_square(heights);
  fade_ends(split.resolved, cutoff);
  return split;
}

}  // namespace gearfilm
