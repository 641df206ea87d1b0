#include "input/face_laws.hpp"

#include <algorithm>
#include <array>

#include "elasticity/row_contact.hpp"

namespace gearfilm {
namespace {

/// All that a law is made from (elasticity/row_contact.hpp).
std::vector<double> made_from(const Scales& scales, const std::array<double, 2>& radii) {
  const Face& face = *scales.solids.face;
  std::vector<double> all = {radii[0],
                             radii[1],
                             scales.radius_ratio,
                             scales.C_h,
                             scales.length,
                             scales.thickness,
                             face.width,
                             scales.static_force,
                             face.gap.slope,
                             face.gap.logarithmic,
                             face.mirror_factor,
                             static_cast<double>(face.end)};
  for (const EndRelief& relief : face.gap.reliefs) {
    all.insert(all.end(), {relief.amount, relief.length, static_cast<double>(relief.power)});
  }
  for (const auto& table : face.gap.tables) {
    all.push_back(static_cast<double>(table.size()));
    for (const auto& [y, gap] : table) all.insert(all.end(), {y, gap});
  }
  for (const EndingBody& body : face.ending) all.insert(all.end(), {body.share, body.poisson_ratio});
  return all;
}

}  // namespace

std::shared_ptr<const FaceLaw> FaceLaws::law(const Scales& scales, const std::optional<LineOfAction>& line) {
  std::array<double, 2> radii = {0.9, 1.1};
  if (line) {
    radii = line->relative_radii();
    radii[1] = std::max(radii[1], 1.01 * radii[0]);
  }
  std::shared_ptr<const FaceLaw>& law = known_[made_from(scales, radii)];
  if (!law) law = std::make_shared<const FaceLaw>(face_law(scales, radii));
  return law;
}

}  // namespace gearfilm
