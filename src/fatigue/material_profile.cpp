#include "fatigue/material_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gearfilm {

double CaseHardening::hardness(double z) const {
  const double rise = surface - core, ratio = z / depth;
  return core + rise * std::exp(-std::log(rise / (550.0 - core)) * ratio * ratio);
}

double DepthTable::operator()(double z) const {
  if (z <= depth.front()) return value.front();
  if (z >= depth.back()) return value.back();
  const auto k = static_cast<std::size_t>(std::ranges::upper_bound(depth, z) - depth.begin());
  const double t = (z - depth[k - 1]) / (depth[k] - depth[k - 1]);
  return (1.0 - t) * value[k - 1] + t * value[k];
}

double residual_stress_of_hardness(double hardness, double core) {
  const double above = hardness - core;
  return 1e6 * (above <= 300.0 ? -1.25 * above : 0.2857 * above - 460.0);
}

double FlankMaterial::hardness(double z) const {
  return hardness_table ? (*hardness_table)(z) : hardening->hardness(z);
}

double FlankMaterial::residual_stress(double z) const {
  if (residual_table) return (*residual_table)(z);
  if (!residual_of_hardness) return 0.0;
  const double core = hardness_table ? hardness_table->value.back() : hardening->core;
  return residual_stress_of_hardness(hardness(z), core);
}

double FlankMaterial::known_to() const {
  double deepest = std::numeric_limits<double>::infinity();
  if (hardness_table) deepest = std::min(deepest, hardness_table->deepest());
  if (residual_table) deepest = std::min(deepest, residual_table->deepest());
  return deepest;
}

}  // namespace gearfilm
