#include "gear/tooth_space.hpp"

#include <cmath>
#include <tuple>

#include "gear/tooth_profile.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

constexpr std::array<const char*, 2> gear_names = {"pinion", "wheel"};

std::array<SpurGear, 2> gears_of(const SpurGearPair& pair) { return {pair.pinion, pair.wheel}; }

double root_radius(const SpurGear& gear, const SpurGearPair& pair, double profile_shift) {
  return gear.root_radius.value_or(standard_root_radius(gear, pair, profile_shift));
}

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  throw InputError(parts...);
}

/// Without a profile shift of its own a tooth is as thick as the assumed one makes it: only what the backlash takes of
/// it is then held against the input.
void check_thickness(const SpurGearPair& pair) {
  const ToothSpace with = tooth_space(pair);
  SpurGearPair tight = pair;
  tight.backlash.reset();
  const ToothSpace without = tooth_space(tight);
  for (int k = 0; k < 2; ++k) {
    const bool by_shift = gears_of(pair)[k].profile_shift.has_value();
    for (const auto& [place, thickness, before] :
         {std::tuple{"tip circle", with.tip_thickness[k], without.tip_thickness[k]},
          std::tuple{"working pitch circle", with.pitch_thickness[k], without.pitch_thickness[k]}}) {
      if (thickness > 0.0) continue;
      if (before > 0.0) {
        refuse("gear_backlash = ", *pair.backlash, " m leaves no tooth of the ", gear_names[k], " at its ", place,
               ", where it is ", before, " m thick without: it is in metres, and usually below a fifth of the module (",
               0.2 * pair.module_length, " m)");
      }
      if (by_shift) {
        refuse(gear_names[k], "_profile_shift = ", *gears_of(pair)[k].profile_shift, " leaves no tooth of the ",
               gear_names[k], " at its ", place, ": change it, or reduce ", gear_names[k], "_outer_radius");
      }
    }
  }
}

void check_shifts(const SpurGearPair& pair) {
  const std::optional<double> backlash = tooth_space(pair).implied_backlash;
  if (!backlash || *backlash >= -largest_overlap * pair.module_length) return;
  refuse("pinion_profile_shift = ", *pair.pinion.profile_shift,
         " and wheel_profile_shift = ", *pair.wheel.profile_shift, " imply a backlash of ", *backlash,
         " m at gear_centre_distance = ", pair.centre_distance,
         " m: the teeth are thicker than the spaces of their mates; shifts of together ", sum_of_profile_shifts(pair),
         " leave none");
}

void check_roots(const SpurGearPair& pair, const LineOfAction& line) {
  const std::array<double, 2> shifts = profile_shifts(pair);
  const std::array<double, 2> foot = {std::hypot(line.base_radius_pinion(), line.radius_pinion(line.entry())),
                                      std::hypot(line.base_radius_wheel(), line.radius_wheel(line.exit()))};
  const ToothSpace space = tooth_space(pair);
  for (int k = 0; k < 2; ++k) {
    const SpurGear gear = gears_of(pair)[k];
    const double root = root_radius(gear, pair, shifts[k]);
    if (gear.root_radius && root >= foot[k]) {
      refuse(gear_names[k], "_root_radius = ", root, " m is not below the active flank, which begins at the radius ",
             foot[k], " m: reduce it, or the mate's outer_radius");
    }
    if (!gear.root_radius && root >= gear.outer_radius) {
      refuse(gear_names[k], "_profile_shift = ", shifts[k], " puts the root circle of a standard rack at ", root,
             " m, not below the tip circle: change it, or give ", gear_names[k], "_root_radius");
    }
    if (gear.bore_radius && *gear.bore_radius >= root) {
      refuse(gear_names[k], "_bore_radius = ", *gear.bore_radius, " m is not below the root radius ", root,
             " m: reduce it");
    }
    const char* mate = gear_names[1 - k];
    if (gears_of(pair)[1 - k].root_radius && space.tip_clearance[k] <= 0.0) {
      refuse("the tips of the ", gear_names[k], " dig ", -space.tip_clearance[k], " m into the roots of the ", mate,
             ": gear_centre_distance = ", pair.centre_distance, " m is less than ", gear_names[k], "_outer_radius and ",
             mate, "_root_radius together");
    }
  }
}

}  // namespace

ToothSpace tooth_space(const SpurGearPair& pair) {
  const std::array<double, 2> shifts = profile_shifts(pair);
  const std::array<SpurGear, 2> gears = gears_of(pair);
  ToothSpace space;
  for (int k = 0; k < 2; ++k) {
    const double pitch_radius = pair.centre_distance * gears[k].teeth / (gears[0].teeth + gears[1].teeth);
    space.tip_thickness[k] = tooth_thickness_at(gears[k].outer_radius, gears[k], pair, shifts[k]);
    space.pitch_thickness[k] = tooth_thickness_at(pitch_radius, gears[k], pair, shifts[k]);
    space.tip_clearance[k] =
        pair.centre_distance - gears[k].outer_radius - root_radius(gears[1 - k], pair, shifts[1 - k]);
  }
  if (pair.pinion.profile_shift && pair.wheel.profile_shift) {
    space.implied_backlash = 2.0 * pair.module_length * std::sin(pair.pressure_angle) *
                             (sum_of_profile_shifts(pair) - shifts[0] - shifts[1]);
  }
  return space;
}

void check_tooth_space(const SpurGearPair& pair, const LineOfAction& line) {
  check_shifts(pair);
  check_thickness(pair);
  check_roots(pair, line);
}

}  // namespace gearfilm
