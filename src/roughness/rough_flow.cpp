#include "roughness/rough_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearfilm {
namespace {

constexpr int lays = 7;
constexpr std::array<double, lays> lay_of = {1.0 / 9.0, 1.0 / 6.0, 1.0 / 3.0, 1.0, 3.0, 6.0, 9.0};
constexpr int isotropic = 3;

struct PressureFlowConstants {
  double C, r, first_z;
};
constexpr std::array<PressureFlowConstants, lays> pressure_flow_constants = {{{1.48, 0.42, 1.0},
                                                                              {1.38, 0.42, 1.0},
                                                                              {1.18, 0.42, 0.75},
                                                                              {0.90, 0.56, 0.5},
                                                                              {0.225, 1.5, 0.5},
                                                                              {0.520, 1.5, 0.5},
                                                                              {0.870, 1.5, 0.5}}};

struct ShearFlowConstants {
  double A_1, a_1, a_2, a_3, A_2;
};
constexpr std::array<ShearFlowConstants, lays> shear_flow_constants = {{{2.046, 1.12, 0.78, 0.03, 1.856},
                                                                        {1.962, 1.08, 0.77, 0.03, 1.754},
                                                                        {1.858, 1.01, 0.76, 0.03, 1.561},
                                                                        {1.899, 0.98, 0.92, 0.05, 1.126},
                                                                        {1.560, 0.85, 1.13, 0.08, 0.556},
                                                                        {1.290, 0.62, 1.09, 0.08, 0.388},
                                                                        {1.011, 0.54, 1.07, 0.08, 0.295}}};

constexpr double smallest_flow = 0.1;  // phi_x from which on the exponential serves

/// Between which lays of the table one lies.
struct Place {
  explicit Place(double lay) {
    while (below < lays - 2 && lay >= lay_of[below + 1]) ++below;
    part = std::log(lay / lay_of[below]) / std::log(lay_of[below + 1] / lay_of[below]);
  }

  int below = 0;
  double part = 0.0;
};

}  // namespace

GapFunction gaussian_mean_gap(double z) {
  constexpr double apart = 8.0;  // beyond it heights add less than round-off
  if (z > apart) return {z, 1.0};
  const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
  const double distribution = 0.5 * std::erfc(-z / std::numbers::sqrt2);
  return {z * distribution + density, distribution};
}

ConductingGap::ConductingGap(double lay) {
  const Place place(lay);
  const PressureFlowConstants &a = pressure_flow_constants[place.below], &b = pressure_flow_constants[place.below + 1];
  const bool blended = place.below == isotropic || place.below + 1 == isotropic;
  if (blended) {
    // The longitudinal branch begins at 3.
    const auto term = [](const PressureFlowConstants& of, double weight, bool power) {
      return Term{weight * (power ? of.C : -of.C), of.r, power};
    };
    terms_ = {term(a, 1.0 - place.part, place.below > isotropic), term(b, place.part, place.below + 1 > isotropic)};
  } else {
    const bool power = place.below > isotropic;
    const double C = std::lerp(a.C, b.C, place.part);
    terms_[0] = {power ? C : -C, std::lerp(a.r, b.r, place.part), power};
  }
  first_ = std::lerp(a.first_z, b.first_z, place.part);
  if (pressure_flow(first_).value < smallest_flow) {
    double high = 10.0;
    for (int n = 0; n < 60; ++n) {
      const double middle = 0.5 * (first_ + high);
      (pressure_flow(middle).value < smallest_flow ? first_ : high) = middle;
    }
  }
  const GapFunction flow = pressure_flow(first_);
  value_ = first_ * std::cbrt(flow.value);
  exponent_ = 1.0 / first_ + flow.slope / (3.0 * flow.value);
}

GapFunction ConductingGap::pressure_flow(double z) const {
  GapFunction flow{1.0, 0.0};
  for (const Term& term : terms_) {
    constexpr double negligible = 36.0;  // exponent
    if (term.factor == 0.0 || (!term.power && term.rate * z > negligible)) continue;
    const double part = term.factor * (term.power ? std::pow(z, -term.rate) : std::exp(-term.rate * z));
    flow.value += part;
    flow.slope -= part * (term.power ? term.rate / z : term.rate);
  }
  return flow;
}

GapFunction ConductingGap::operator()(double z) const {
  if (z < first_) {
    const double value = value_ * std::exp(exponent_ * (z - first_));
    return {value, exponent_ * value};
  }
  const GapFunction flow = pressure_flow(z);
  if (flow.value == 1.0) return {z, 1.0};
  const double root = std::cbrt(flow.value);
  return {z * root, root + z * flow.slope / (3.0 * root * root)};
}

ShearFlow::ShearFlow(double lay) {
  const Place place(lay);
  const ShearFlowConstants &a = shear_flow_constants[place.below], &b = shear_flow_constants[place.below + 1];
  A_1_ = std::lerp(a.A_1, b.A_1, place.part);
  a_1_ = std::lerp(a.a_1, b.a_1, place.part);
  a_2_ = std::lerp(a.a_2, b.a_2, place.part);
  a_3_ = std::lerp(a.a_3, b.a_3, place.part);
  A_2_ = std::lerp(a.A_2, b.A_2, place.part);
}

GapFunction ShearFlow::operator()(double z) const {
  constexpr double far = 5.0, rate = 0.25, smallest = 1e-6;
  if (z > far) {
    const double value = A_2_ * std::exp(-rate * z);
    return {value, -rate * value};
  }
  const double at = std::max(z, smallest);
  const double value = A_1_ * std::pow(at, a_1_) * std::exp(-a_2_ * at + a_3_ * at * at);
  return {value, z < smallest ? 0.0 : value * (a_1_ / at - a_2_ + 2.0 * a_3_ * at)};
}

}  // namespace gearfilm
