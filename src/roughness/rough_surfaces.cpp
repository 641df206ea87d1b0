#include "roughness/rough_surfaces.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

double combined_lay(const RoughOptions& options) {
  const double first = options.roughness[0] * options.roughness[0],
               second = options.roughness[1] * options.roughness[1];
  if (options.lay[0] == options.lay[1]) return options.lay[0];
  return std::exp((first * std::log(options.lay[0]) + second * std::log(options.lay[1])) / (first + second));
}

/// (Rq_i/sigma)^2.
std::array<double, 2> shares(const RoughOptions& options, double sigma) {
  const auto share = [&](double roughness) { return roughness * roughness / (sigma * sigma); };
  return {share(options.roughness[0]), share(options.roughness[1])};
}

}  // namespace

RoughSurfaces::RoughSurfaces(const RoughOptions& options, double reduced_modulus)
    : options_(options),
      sigma_(std::hypot(options.roughness[0], options.roughness[1])),
      share_(shares(options, sigma_)),
      lay_(combined_lay(options)),
      asperities_(options.asperities, reduced_modulus),
      along_(lay_),
      across_(1.0 / lay_),
      shear_{ShearFlow(options.lay[0]), ShearFlow(options.lay[1])},
      table_([this](double z) { return functions_at(z); }, isotropic(), has_shear_flow()) {}

GapValues RoughSurfaces::functions_at(double z) const {
  const AsperityLaw::Value asperities = asperities_(z);
  const GapFunction along = conducting_along(z);
  return {asperities.pressure,
          asperities.slope,
          mean_gap(z),
          along,
          isotropic() ? along : conducting_across(z),
          has_shear_flow() ? shear_flow(z) : GapFunction{0.0, 0.0}};
}

GapValues RoughSurfaces::beyond_table(double z) const { return z >= GapTable::last ? table_.far(z) : functions_at(z); }

GapFunction RoughSurfaces::shear_flow(double z) const {
  const GapFunction first = shear_[0](z), second = shear_[1](z);
  return {share_[0] * first.value - share_[1] * second.value, share_[0] * first.slope - share_[1] * second.slope};
}

}  // namespace gearfilm
