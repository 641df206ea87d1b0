#include "gearfilm/dynamics/dry_force.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

double force_at_unit_approach(const Scales& scales, double relative_radius) {
  const double load = hertz_load(solids_of(scales, {.relative_radius = relative_radius}), scales.thickness);
  return load / scales.operation.load * scales.static_force;
}

/// F of q F^(2/3) + c F = approach: with y = F^(1/3) convex and increasing, so that Newton's method from above
/// converges monotonically.
double force_on_spring(double unit_force, double compliance, double approach) {
  if (approach <= 0.0) return 0.0;
  if (compliance == 0.0) return unit_force * approach * std::sqrt(approach);
  const double root = std::cbrt(unit_force), q = 1.0 / (root * root);
  double y = std::sqrt(approach / q);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double step = (q * y * y + compliance * y * y * y - approach) / (2.0 * q * y + 3.0 * compliance * y * y);
    y -= step;
    if (step <= 1e-15 * y) break;
  }
  return y * y * y;
}

}  // namespace

DryForce::DryForce(const MeshModel& mesh) {
  // R_x is a parabola over the path, largest midway between the base circles: its ends have the smallest.
  const LineOfAction& line = mesh.path.line();
  const double from_pinion = line.radius_pinion(0.0), from_wheel = line.radius_wheel(0.0);
  const double top = std::clamp(0.5 * (from_wheel - from_pinion), line.entry(), line.exit());
  const double reference = mesh.scales.solids.radius_x;
  const double low = std::log(std::min(line.radius_x(line.entry()), line.radius_x(line.exit())) / reference);
  const double high = std::log(line.radius_x(top) / reference);
  const double middle = 0.5 * (low + high), half_range = std::max(0.5 * (high - low), 1e-3);
  logarithm_ = {middle - half_range, middle + half_range,
                [&](double radius) { return std::log(force_at_unit_approach(mesh.scales, std::exp(radius))); }};
}

double DryForce::at_unit_approach(const ContactConditions& conditions) const {
  return std::exp(logarithm_(std::log(conditions.relative_radius)));
}

DryContacts::DryContacts(const DryForce& force, const MeshModel& mesh, const std::vector<int>& numbers, double T) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const ContactConditions conditions = mesh.contact(numbers[k], T).conditions;
    contacts_.push_back({conditions.gap_offset, force.at_unit_approach(conditions), mesh.compliance(numbers[k], T)});
    coupling_.push_back(k == 0 ? 0.0 : mesh.coupling(static_cast<int>(k)));
  }
}

bool DryContacts::coupled() const {
  return std::ranges::any_of(coupling_, [](double c) { return c != 0.0; });
}

// Gauss and Seidel: a contraction, since a neighbour's force bends a tooth less than its own.
std::vector<double> DryContacts::forces(double H0) const {
  constexpr double tolerance = 1e-14;
  std::vector<double> forces(contacts_.size(), 0.0);
  const int most = coupled() ? 500 : 1;
  for (int sweep = 0; sweep < most; ++sweep) {
    double change = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      double approach = -(H0 + contacts_[k].gap);
      for (std::size_t j = 0; j < contacts_.size(); ++j) {
        if (j != k) approach -= coupling(k, j) * forces[j];
      }
      const double force = force_on_spring(contacts_[k].unit_force, contacts_[k].compliance, approach);
      change = std::max(change, std::abs(force - forces[k]));
      largest = std::max(largest, force);
      forces[k] = force;
    }
    if (change <= tolerance * largest) break;
  }
  return forces;
}

double DryContacts::total_force(double H0) const {
  const std::vector<double> all = forces(H0);
  return std::accumulate(all.begin(), all.end(), 0.0);
}

// (D + C) dF = 1, D_k = d(q F^(2/3))/dF, over the contacts that carry.
double DryContacts::stiffness(const std::vector<double>& forces) const {
  std::vector<std::size_t> carrying;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces[k] > 0.0) carrying.push_back(k);
  }
  const std::size_t size = carrying.size();
  std::vector<std::vector<double>> rows(size, std::vector<double>(size + 1, 1.0));
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) rows[i][j] = coupling(carrying[i], carrying[j]);
    const double root = std::cbrt(contacts_[carrying[i]].unit_force);
    rows[i][i] += 2.0 / (3.0 * root * root * std::cbrt(forces[carrying[i]]));
  }
  // Gauss and Jordan: the matrix is positive definite.
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < size; ++k) {
      if (k == i) continue;
      const double part = rows[k][i] / rows[i][i];
      for (std::size_t j = i; j <= size; ++j) rows[k][j] -= part * rows[i][j];
    }
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < size; ++i) sum += rows[i][size] / rows[i][i];
  return sum;
}

// The total force falls monotonically with H_0, to zero where the last gap opens.
double DryContacts::balance(double load) const {
  double high = -HUGE_VAL;
  for (const Contact& contact : contacts_) high = std::max(high, -contact.gap);
  double depth = 1.0;
  while (total_force(high - depth) < load) {
    depth *= 2.0;
    if (depth > 1e9) throw SolveError("the dry contacts do not carry the load at any approach");
  }
  double low = high - depth;
  for (int iteration = 0; iteration < 200 && high - low > 1e-15 * std::max(1.0, std::abs(low)); ++iteration) {
    const double middle = 0.5 * (low + high);
    (total_force(middle) > load ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace gearfilm
