#include "gear/iso_stiffness.hpp"

namespace gearfilm {
namespace {

constexpr double steel_modulus = 206e9;  // [Pa]

}  // namespace

IsoStiffness iso_stiffness(const SpurGearPair& pair, double contact_ratio) {
  const std::array<double, 2> x = profile_shifts(pair);
  const double Z1 = pair.pinion.teeth, Z2 = pair.wheel.teeth;
  // [mm um/N]
  const double q = 0.04723 + 0.15551 / Z1 + 0.25791 / Z2 - 0.00635 * x[0] - 0.11654 * x[0] / Z1 - 0.00193 * x[1] -
                   0.24188 * x[1] / Z2 + 0.00529 * x[0] * x[0] + 0.00182 * x[1] * x[1];
  const double E1 = pair.pinion.youngs_modulus, E2 = pair.wheel.youngs_modulus;
  const double material = 2.0 * E1 * E2 / (E1 + E2) / steel_modulus;
  const double single = 0.8 / q * 1e9 * pair.face_width * material;
  return {single, single * (0.75 * contact_ratio + 0.25)};
}

}  // namespace gearfilm
