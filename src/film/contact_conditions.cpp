#include "film/contact_conditions.hpp"

#include <algorithm>

namespace gearfilm {

// The curvature is taken over the width of a loaded contact: kinks have none of their own.
NearestPoint nearest_point(const Scales& scales, const ContactConditions& conditions) {
  constexpr int places = 40;                      // on either side
  constexpr double step = 0.1, half_width = 0.5;  // [a]
  const double along_face = scales.face_law ? -scales.face_law->nearest() : 0.0;
  if (!conditions.local.flanks) return {.drop = along_face};
  const auto gap = [&](double X) {
    return 0.5 * X * X / conditions.relative_radius + conditions.local(X * scales.length) / scales.thickness;
  };
  NearestPoint nearest;
  double lowest = gap(0.0);
  for (int n = 0; n <= 2 * places; ++n) {
    const double X = (n - places) * step, here = gap(X);
    if (here >= lowest) continue;
    lowest = here;
    nearest.X = X;
  }
  nearest.drop = along_face - lowest;
  const double curvature =
      (gap(nearest.X + half_width) - 2.0 * lowest + gap(nearest.X - half_width)) / (half_width * half_width);
  const double most = NearestPoint::widest_ratio / conditions.relative_radius;
  const double least = 1.0 / (NearestPoint::widest_ratio * conditions.relative_radius);
  nearest.relative_radius = 1.0 / std::clamp(curvature, least, most);
  return nearest;
}

ContactSolids solids_of(const Scales& scales, const ContactConditions& conditions) {
  ContactSolids solids = scales.solids;
  solids.radius_x *= conditions.dry_radius();
  return solids;
}

HertzContact dry_contact(const Scales& scales, const ContactConditions& conditions, double pressure_integral) {
  if (!scales.face_law) return hertz_contact(solids_of(scales, conditions), scales.force(pressure_integral));
  const FaceContact dry = scales.face_law->at_force(pressure_integral, conditions.dry_radius());
  return {.ellipticity = scales.hertz.ellipticity,
          .a = scales.length * dry.half_width,
          .b = scales.hertz.b,
          .pressure = scales.pressure * dry.pressure,
          .approach = scales.thickness * dry.approach};
}

ContactLaw contact_law(const Scales& scales, const ContactConditions& conditions) {
  if (scales.face_law) return ContactLaw::of_face(scales.face_law, conditions.dry_radius());
  return ContactLaw::of_ellipse(force_at_unit_approach(scales, conditions));
}

double force_at_unit_approach(const Scales& scales, const ContactConditions& conditions) {
  return hertz_load(solids_of(scales, conditions), scales.thickness) / scales.operation.load * scales.static_force;
}

}  // namespace gearfilm
