#include "dynamics/backward_differences.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/slope_weights.hpp"

namespace gearfilm {
namespace {

/// Values at T of the Lagrange polynomials of these times.
std::vector<double> lagrange_values(const std::vector<double>& times, double T) {
  std::vector<double> values(times.size(), 1.0);
  for (std::size_t k = 0; k < times.size(); ++k) {
    for (std::size_t j = 0; j < times.size(); ++j) {
      if (j != k) values[k] *= (T - times[j]) / (times[k] - times[j]);
    }
  }
  return values;
}

template <std::size_t size>
void combine(const std::array<OwnedVec, size>& vectors, const double* factors, int count, Vec sum) {
  std::array<Vec, size> raw{};
  std::ranges::copy(vectors, raw.begin());
  petsc_check(VecZeroEntries(sum));
  petsc_check(VecMAXPY(sum, count, factors, raw.data()));
}

}  // namespace

BackwardDifferences::BackwardDifferences(const std::function<OwnedVec()>& create)
    : sought_(create()),
      states_{create(), create(), create()},
      transients_{create(), create(), create()},
      constant_(create()) {}

void BackwardDifferences::keep(double T, bool behind, const std::function<void(Vec, Vec)>& transient) {
  const int place = behind ? 1 : 0;
  std::rotate(states_.begin() + place, states_.end() - 1, states_.end());
  std::rotate(times_.begin() + place, times_.end() - 1, times_.end());
  std::rotate(transients_.begin() + place, transients_.end() - 1, transients_.end());
  std::swap(states_[place], sought_);
  times_[place] = T;
  known_ = std::min(known_ + 1, static_cast<int>(states_.size()));
  transient(states_[place], transients_[place]);
}

std::vector<double> BackwardDifferences::times_at(double T, int known) const {
  std::vector<double> times = {T};
  times.insert(times.end(), times_.begin(), times_.begin() + known);
  return times;
}

void BackwardDifferences::differentiate(double T, int order) {
  stage_ = T;
  order_ = order;
  const std::vector<double> factors = weights(order);
  shift_ = factors[0];
  combine(transients_, factors.data() + 1, order, constant_);
}

// A state that stands behind an earlier one has no step of its own.
bool BackwardDifferences::evenly_spaced(double T, int states) const {
  constexpr double longest_over_shortest = 1.5;
  if (known_ < states) return false;
  const std::vector<double> times = times_at(T, states);
  double shortest = HUGE_VAL, longest = -HUGE_VAL;
  for (std::size_t n = 1; n < times.size(); ++n) {
    shortest = std::min(shortest, times[n - 1] - times[n]);
    longest = std::max(longest, times[n - 1] - times[n]);
  }
  return longest < longest_over_shortest * shortest;
}

std::vector<double> BackwardDifferences::weights(int order) const { return slope_weights(times_at(stage_, order)); }

std::complex<double> BackwardDifferences::of_oscillation(double w, int order) const {
  return slope_of_oscillation(w, times_at(stage_, order));
}

void BackwardDifferences::make_rate(Vec values) const { petsc_check(VecAYPX(values, shift_, constant_)); }

std::vector<double> BackwardDifferences::extrapolate(double T, int states) {
  const int count = std::min(states, known_);
  std::vector<double> weights = lagrange_values({times_.begin(), times_.begin() + count}, T);
  combine(states_, weights.data(), count, sought_);
  return weights;
}

double BackwardDifferences::error(double T, int order, Vec allowed) {
  std::vector<double> factors = slope_weights(times_at(T, order));
  const double scale = factors[0];
  factors.push_back(0.0);
  const std::vector<double> finer = slope_weights(times_at(T, order + 1));
  for (std::size_t n = 0; n < factors.size(); ++n) factors[n] = (factors[n] - finer[n]) / scale;
  combine(states_, factors.data() + 1, order + 1, constant_);
  petsc_check(VecAXPY(constant_, factors[0], sought_));
  petsc_check(VecPointwiseDivide(constant_, constant_, allowed));
  PetscReal norm = 0.0;
  PetscInt size = 0;
  petsc_check(VecNorm(constant_, NORM_2, &norm));
  petsc_check(VecGetSize(constant_, &size));
  return norm / std::sqrt(static_cast<double>(size));
}

}  // namespace gearfilm
