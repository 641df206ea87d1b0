#include "fatigue/fatigue_model.hpp"

#include <algorithm>

namespace gearfilm {

double FatigueModel::safety(std::size_t body, double z, double dang_van_stress) const {
  const double residual = material[body].residual_stress(z);
  return dang_van_safety(dang_van_stress, limit(body, z),
                         dang_van.compression_helps ? residual : std::max(residual, 0.0), dang_van.alpha);
}

}  // namespace gearfilm
