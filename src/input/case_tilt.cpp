#include "input/case_tilt.hpp"

#include "input/case_face.hpp"

namespace gearfilm {

std::shared_ptr<const Face> face_under_load(const ParameterValues& values, PairCase& pair, ContactSolids solids,
                                            const Lubricant& oil) {
  std::shared_ptr<const Face> face = read_face_of_pair(values);
  if (!pair.train || !(pair.train->two_bearings[0] || pair.train->two_bearings[1])) return face;
  solids.face = face;
  const ContactOperation operation{.load = pair.tooth_force,
                                   .entrainment_velocity = pair.line->entrainment_velocity(0.0, pair.pinion_speed)};
  pair.tilt = in_file_of(values, [&] {
    return shaft_tilt(make_scales(solids, oil, operation), pair.train->two_bearings,
                      pair.line->working_pressure_angle());
  });
  Face tilted = *face;
  tilted.gap.slope += pair.tilt->slope();
  return std::make_shared<const Face>(tilted);
}

}  // namespace gearfilm
