#include "fatigue/smallest_ball.hpp"

#include <algorithm>
#include <vector>

#include "algebra/dense.hpp"

namespace gearfilm {
namespace {

using Points = std::vector<DeviatorPoint>;

constexpr double outside = 1e-9;       // relative to the radius
constexpr double in_hull = 1e-12;      // distance of the centre from the affine hull, relative to the radius
constexpr double not_outward = -1e-9;  // barycentric coordinates

std::size_t farthest_from(const DeviatorPoint& centre, std::span<const DeviatorPoint> points) {
  const auto distance = [&](const DeviatorPoint& point) { return (point - centre).squaredNorm(); };
  return std::ranges::max_element(points, {}, distance) - points.begin();
}

/// The centre's projection on the affine hull of the support, and its barycentric coordinates there.
struct Projection {
  DeviatorPoint place;
  std::vector<double> coordinates;
};

Projection project(const DeviatorPoint& centre, const Points& core, const std::vector<std::size_t>& support) {
  const DeviatorPoint& origin = core[support.front()];
  const auto edges = static_cast<Eigen::Index>(support.size()) - 1;
  Projection found{origin, {1.0}};
  if (edges == 0) return found;
  Eigen::Matrix<double, 5, Eigen::Dynamic> edge(5, edges);
  for (Eigen::Index n = 0; n < edges; ++n) edge.col(n) = core[support[n + 1]] - origin;
  const Eigen::VectorXd weights = least_squares(edge, centre - origin);
  found.place = origin + edge * weights;
  found.coordinates.front() -= weights.sum();
  found.coordinates.insert(found.coordinates.end(), weights.begin(), weights.end());
  return found;
}

/// The part of the way d of the centre after which a point outside the support touches the ball, and the point.
std::pair<double, std::size_t> first_touch(const DeviatorPoint& centre, const DeviatorPoint& d, const Points& core,
                                           const std::vector<std::size_t>& support) {
  const DeviatorPoint& touching = core[support.front()];
  const double radius = (touching - centre).squaredNorm();
  std::pair<double, std::size_t> first{1.0, core.size()};
  for (std::size_t n = 0; n < core.size(); ++n) {
    if (std::ranges::count(support, n) > 0) continue;
    const double towards = d.dot(touching - core[n]);
    if (!(towards > 0.0)) continue;
    const double part = std::max(0.0, (radius - (core[n] - centre).squaredNorm()) / (2.0 * towards));
    if (part < first.first) first = {part, n};
  }
  return first;
}

Ball walk(const Points& core) {
  DeviatorPoint centre = core.front();
  std::vector<std::size_t> support{farthest_from(centre, core)};
  const double size = (core[support.front()] - centre).norm();
  // Every turn adds or drops a point; degenerate sets could go round.
  for (std::size_t turn = 0; turn < 100 * core.size() && size > 0.0; ++turn) {
    const Projection projection = project(centre, core, support);
    const DeviatorPoint d = projection.place - centre;
    if (d.norm() <= in_hull * size) {
      const auto least = std::ranges::min_element(projection.coordinates);
      if (*least >= not_outward) break;
      support.erase(support.begin() + (least - projection.coordinates.begin()));
      continue;
    }
    const auto [part, touched] = first_touch(centre, d, core, support);
    centre += part * d;
    if (touched < core.size()) support.push_back(touched);
  }
  return {centre, (core[farthest_from(centre, core)] - centre).norm()};
}

}  // namespace

Ball smallest_ball(std::span<const DeviatorPoint> points) {
  DeviatorPoint mean = DeviatorPoint::Zero();
  for (const DeviatorPoint& point : points) mean += point / static_cast<double>(points.size());
  std::vector<std::size_t> chosen{farthest_from(mean, points)};
  chosen.push_back(farthest_from(points[chosen.front()], points));
  for (;;) {
    Points core;
    for (const std::size_t n : chosen) core.push_back(points[n]);
    Ball ball = walk(core);
    const std::size_t far = farthest_from(ball.centre, points);
    const bool held = (points[far] - ball.centre).norm() <= ball.radius * (1.0 + outside);
    if (held || std::ranges::count(chosen, far) > 0) return ball;
    chosen.push_back(far);
  }
}

}  // namespace gearfilm
