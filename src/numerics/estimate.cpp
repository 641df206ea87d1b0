#include "numerics/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearfilm {
namespace {

constexpr double slow_convergence = 1.5;  // error of smallest films and pressures, in that of second order
constexpr double least_growth = 0.13;     // of an unresolved spike in one doubling of the nodes, of its height
constexpr double sudden_growth = 0.25;    // of one that the coarser grid has not
constexpr double doublings = 2.0;         // that the bar of a spike is for
constexpr double missed_part = 0.12;      // of step times height: change of the pressures beside a spike
constexpr double least_curvature = 0.25;  // of the step's square: a top between two nodes is missed by an eighth

/// In one doubling of the nodes, of its height.
double spike_growth(double fine, double coarse, double ratio) {
  if (!(coarse > 0.0)) return sudden_growth;
  const double of_doubling = std::numbers::ln2 / std::log(ratio) * std::abs(std::log(fine / coarse));
  return std::max(least_growth, std::expm1(of_doubling));
}

}  // namespace

double Estimate::relative_error() const { return error / std::max(std::abs(value), least); }

double Estimate::relative_rest() const {
  return std::abs(extrapolated.value() - value) / std::max(std::abs(value), least);
}

Estimate estimate(double fine, double coarse, double ratio) {
  const double difference = (fine - coarse) / (ratio * ratio - 1.0);
  return {fine, std::abs(difference), fine + difference};
}

Estimate estimate_smallest(double fine, double coarse, double ratio) {
  Estimate smallest = estimate(fine, coarse, ratio);
  smallest.error *= slow_convergence;
  return smallest;
}

Estimate estimate_fast(double fine, double coarse, double least, double ratio) {
  const double difference = fine - coarse, square = ratio * ratio;
  return {fine, std::max(std::abs(difference) / square, least * std::abs(fine)),
          fine + difference / (ratio * ratio * ratio - 1.0)};
}

std::optional<Estimate> estimate_spike(double fine, double coarse, double ratio) {
  if (!(fine > 0.0)) return {};
  return Estimate{fine, doublings * spike_growth(fine, coarse, ratio) * fine};
}

Estimate estimate_beside_spike(const PeakPressures& fine, const PeakPressures& coarse, double step, double ratio) {
  Estimate beside = estimate(fine.pressure, coarse.pressure, ratio);
  beside.error = std::max({slow_convergence * beside.error, missed_part * step * fine.spike,
                           least_curvature * step * step * fine.pressure});
  return beside;
}

Estimate estimate_largest(const PeakPressures& fine, const PeakPressures& coarse, double step, double ratio) {
  Estimate largest = estimate_beside_spike(fine, coarse, step, ratio);
  const std::optional<Estimate> spike = estimate_spike(fine.spike, coarse.spike, ratio);
  if (!spike) return largest;
  const double growth = spike->value + spike->error - fine.pressure;
  if (growth <= largest.error) return largest;
  return {fine.pressure, growth};
}

}  // namespace gearfilm
