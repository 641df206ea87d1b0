#include "mesh/dry_force.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "algebra/dense.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {

DryForce::DryForce(const MeshModel& mesh) : face_(mesh.scales.face_law) {
  if (face_) return;
  const auto [smallest, largest] = mesh.path.line().relative_radii();
  const double low = std::log(smallest), high = std::log(largest);
  const bool local = mesh.teeth.local(0.0).flanks != nullptr;
  const double beyond = local ? std::log(NearestPoint::widest_ratio) : 0.0;
  const double middle = 0.5 * (low + high), half_range = std::max(0.5 * (high - low) + beyond, 1e-3);
  logarithm_ = {middle - half_range, middle + half_range, [&](double radius) {
                  return std::log(force_at_unit_approach(mesh.scales, {.relative_radius = std::exp(radius)}));
                }};
}

ContactLaw DryForce::law(const ContactConditions& conditions) const {
  if (face_) return ContactLaw::of_face(face_, conditions.dry_radius());
  return ContactLaw::of_ellipse(std::exp(logarithm_(std::log(conditions.dry_radius()))));
}

DryContacts::DryContacts(const DryForce& force, const MeshModel& mesh, const std::vector<int>& numbers, double T)
    : compliance_(mesh.compliance(numbers, T)), coupled_(compliance_.coupled()), elliptic_(!mesh.scales.face_law) {
  contacts_.reserve(numbers.size());
  for (const int number : numbers) {
    const ContactConditions conditions = mesh.contact(number, T).conditions;
    contacts_.push_back({conditions.dry_gap(), force.law(conditions)});
  }
}

bool DryContacts::same_as(const DryContacts& others) const {
  constexpr double round_off = 1e-12;
  if (contacts_.size() != others.contacts_.size()) return false;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Contact &one = contacts_[k], &other = others.contacts_[k];
    if (std::abs(one.gap - other.gap) > round_off * std::max(1.0, std::abs(one.gap))) return false;
    if (std::abs(one.law.approach(1.0) / other.law.approach(1.0) - 1.0) > round_off) return false;
    for (std::size_t j = 0; j < contacts_.size(); ++j) {
      const double c = compliance_(k, j);
      if (std::abs(others.compliance_(k, j) - c) > round_off * c) return false;
    }
  }
  return true;
}

void DryContacts::stand_for(const std::vector<double>& forces, const std::vector<double>& displacements) {
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    if (forces[k] <= 0.0) continue;
    contacts_[k].gap = -displacements[k] - contacts_[k].law.approach(forces[k]);
  }
}

double DryContacts::approach(std::size_t contact, double H0, const std::vector<double>& forces) const {
  double left = -(H0 + contacts_[contact].gap);
  for (std::size_t j = 0; j < contacts_.size(); ++j) {
    if (j != contact) left -= compliance_(contact, j) * forces[j];
  }
  return left;
}

// Gauss and Seidel: a contraction, since a neighbour's force bends a tooth less than its own.
std::vector<double> DryContacts::forces(double H0) const {
  constexpr double tolerance = 1e-14;
  std::vector<double> forces(contacts_.size(), 0.0);
  const int most = coupled_ ? 500 : 1;
  for (int sweep = 0; sweep < most; ++sweep) {
    double change = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const double force = contacts_[k].law.force(approach(k, H0, forces), compliance_(k, k));
      change = std::max(change, std::abs(force - forces[k]));
      largest = std::max(largest, force);
      forces[k] = force;
    }
    if (change <= tolerance * largest) break;
  }
  return forces;
}

// q_k y_k^2 + sum_j c_kj y_j^3 = -(H_0 + e_k) with y = F^(1/3), by Newton's method.
bool DryContacts::follow(double H0, std::vector<double>& forces) const {
  constexpr int most_iterations = 8;
  constexpr double tolerance = 1e-9;  // before the last step, which squares it
  const std::size_t count = contacts_.size();
  if (!elliptic_ || count == 0 || count > 2 || forces.size() != count) return false;
  std::array<double, 2> y{}, q{};
  for (std::size_t k = 0; k < count; ++k) {
    if (!(forces[k] > 0.0)) return false;
    y[k] = std::cbrt(forces[k]);
    q[k] = contacts_[k].law.approach(1.0);
  }
  const auto c = [&](std::size_t k, std::size_t j) { return compliance_(k, j); };
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const auto defect = [&](std::size_t k) {
      double left = H0 + contacts_[k].gap + q[k] * y[k] * y[k];
      for (std::size_t j = 0; j < count; ++j) left += c(k, j) * y[j] * y[j] * y[j];
      return left;
    };
    const auto slope = [&](std::size_t k, std::size_t j) {
      return (k == j ? 2.0 * q[k] * y[k] : 0.0) + 3.0 * c(k, j) * y[j] * y[j];
    };
    std::array<double, 2> step{};
    if (count == 1) {
      step[0] = defect(0) / slope(0, 0);
    } else {
      const double left = defect(0), right = defect(1), across = slope(0, 1), back = slope(1, 0);
      const double determinant = slope(0, 0) * slope(1, 1) - across * back;
      step = {(left * slope(1, 1) - across * right) / determinant, (slope(0, 0) * right - back * left) / determinant};
    }
    bool done = true;
    for (std::size_t k = 0; k < count; ++k) {
      y[k] -= step[k];
      if (!(y[k] > 0.0)) return false;
      done = done && std::abs(step[k]) <= tolerance * y[k];
    }
    if (!done) continue;
    for (std::size_t k = 0; k < count; ++k) forces[k] = y[k] * y[k] * y[k];
    return true;
  }
  return false;
}

// By Newton's method: F_k = f_k(approach_k) with approach_k less what the others' forces take of it, (I + S C') dF = f
// - F, C' without its diagonal. Where gaps close it may jump to and fro; then as without a guess.
std::vector<double> DryContacts::forces_near(double H0, const std::vector<double>& guess) const {
  constexpr int most_iterations = 12, most_contacts = 4;
  constexpr double tolerance = 1e-11;  // before the last step, which squares it
  const auto count = static_cast<Eigen::Index>(contacts_.size());
  std::vector<double> found = guess;
  if (follow(H0, found)) return found;
  if (!coupled_ || count > most_contacts || guess.size() != contacts_.size()) return forces(H0);
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_contacts, 1>;
  Eigen::Map<Vector> all(found.data(), count);
  Vector defect(count);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_contacts, most_contacts> slope(count, count);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    for (Eigen::Index k = 0; k < count; ++k) {
      const ContactLaw& law = contacts_[static_cast<std::size_t>(k)].law;
      const double force = law.force(approach(static_cast<std::size_t>(k), H0, found), compliance_(k, k));
      const double stiffness = force > 0.0 ? 1.0 / (1.0 / law.stiffness(force) + compliance_(k, k)) : 0.0;
      for (Eigen::Index j = 0; j < count; ++j) slope(k, j) = j == k ? 1.0 : stiffness * compliance_(k, j);
      defect[k] = force - all[k];
    }
    const double change = defect.lpNorm<Eigen::Infinity>();
    all += slope.partialPivLu().solve(defect);
    if (change <= tolerance * all.lpNorm<Eigen::Infinity>()) {
      all = all.cwiseMax(0.0);
      return found;
    }
  }
  return forces(H0);
}

double DryContacts::total_force(double H0) const {
  const std::vector<double> all = forces(H0);
  return std::accumulate(all.begin(), all.end(), 0.0);
}

double DryContacts::largest_approach(double H0) const {
  double largest = -HUGE_VAL;
  for (const Contact& contact : contacts_) largest = std::max(largest, -(H0 + contact.gap));
  return largest;
}

// (D + C) dF = 1, D_k = d(q F^(2/3))/dF: with S = 1/D, which is zero without a force, (I + S C) dF = S.
double DryContacts::stiffness(const std::vector<double>& forces) const {
  Eigen::VectorXd own(static_cast<Eigen::Index>(forces.size()));
  for (std::size_t k = 0; k < forces.size(); ++k) own[k] = contacts_[k].law.stiffness(forces[k]);
  if (!coupled_) {
    double sum = 0.0;
    for (std::size_t k = 0; k < forces.size(); ++k) sum += own[k] / (1.0 + own[k] * compliance_(k, k));
    return sum;
  }
  return solved(compliance_.coupling_matrix(own), own).sum();
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
