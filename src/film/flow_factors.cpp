#include "film/flow_factors.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

constexpr double no_shear = -12.0;  // kappa + x of S = 1 to ten digits

}  // namespace

FlowFactors FlowFactors::none(std::size_t nodes) {
  FlowFactors flow;
  for (auto* field : {&flow.log_poiseuille, &flow.entrainment_excess}) field->assign(nodes, 0.0);
  for (auto* field : {&flow.density_ratio, &flow.cross_flow}) field->assign(nodes, 1.0);
  flow.shear_index.assign(nodes, -40.0);
  return flow;
}

double shear_of(double power, double log_factor, double x) {
  const double exponent = 2.0 * log_factor / power;
  // ln(e^s - 1)/2 without overflow.
  const double rate = exponent > 0.0 ? 0.5 * (exponent + std::log(-std::expm1(-exponent))) : no_shear;
  return std::max(rate, no_shear) - x;
}

}  // namespace gearfilm
