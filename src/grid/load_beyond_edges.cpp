#include "grid/load_beyond_edges.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

/// Where a falling function of the edge's place comes down to `allowed`, between two places.
template <class Load>
double edge(double inner, double outer, double allowed, Load load_beyond) {
  if (load_beyond(inner) <= allowed) return inner;
  constexpr double close = 1e-3;
  while (outer - inner > close) {
    const double middle = 0.5 * (inner + outer);
    (load_beyond(middle) > allowed ? inner : outer) = middle;
  }
  return outer;
}

/// Of a line contact, in units of a^2/R_x.
double dry_gap(double X) {
  const double root = std::sqrt(X * X - 1.0);
  return 0.5 * (X * root - std::log(X + root));
}

}  // namespace

LoadBeyondEdges::LoadBeyondEdges(const Scales& scales, double swinging, double entering)
    : lambda_(scales.lambda),
      swinging_(swinging),
      fastest_(std::max(swinging, entering)),
      film_(ExpectedFilm(scales).film),
      rise_(0.5 * scales.radius_ratio / (scales.hertz.ellipticity * scales.hertz.ellipticity)),
      blunt_(std::sqrt(std::max(1.0 - film_ / rise_, 1e-4))) {}

double LoadBeyondEdges::sides(double y) const {
  const double q = blunt_, by_wedge = std::log((y + q) / (y - q)) / (2.0 * rise_ * q);
  const double by_approach = 2.7 * swinging_ * (y / std::sqrt(y * y - q * q) - 1.0) / (std::pow(rise_, 1.5) * q * q);
  return 0.39 * lambda_ * (by_wedge + by_approach);
}

double LoadBeyondEdges::outlet(double X) const {
  constexpr int points = 200;
  // By z from 0 to 1, at the places X/z: what is summed falls with the fourth power of the place.
  double sum = 0.0;
  for (int n = 0; n < points; ++n) {
    const double z = (n + 0.5) / points, gap = film_ + dry_gap(X / z);
    sum += X / (z * z * gap * gap * points);
  }
  return 0.48 * lambda_ * fastest_ * sum;
}

Domain carrying_behind(Domain domain, const LoadBeyondEdges& load) {
  constexpr double behind_outlet = 0.015, farthest_outlet = 40.0;
  domain.x_max = edge(domain.x_max, farthest_outlet, behind_outlet, [&](double X) { return load.outlet(X); });
  return domain;
}

Domain carrying_beside(Domain domain, const LoadBeyondEdges& load, double half_face) {
  constexpr double beyond_sides = 0.002;
  if (domain.y_half >= half_face) return domain;
  const double beyond_face = load.sides(half_face);
  domain.y_half = edge(domain.y_half, half_face, beyond_sides, [&](double y) { return load.sides(y) - beyond_face; });
  return domain;
}

}  // namespace gearfilm
