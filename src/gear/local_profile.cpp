#include "gear/local_profile.hpp"

namespace gearfilm {

double LocalProfile::operator()(double x) const {
  if (!flanks) return 0.0;
  const auto beside = [&](std::size_t gear, double along) {
    const Flank& flank = (*flanks)[gear];
    return flank.removed(radius_beside(rho[gear], base_radius[gear], along)) - flank.removed(rho[gear]);
  };
  return beside(0, -x) + beside(1, x);
}

}  // namespace gearfilm
