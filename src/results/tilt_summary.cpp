#include "results/tilt_summary.hpp"

#include <iomanip>

#include "gearfilm/error.hpp"
#include "results/members.hpp"

namespace gearfilm {
namespace {

struct TiltOfPair {
  const ShaftTilt& tilt;
  double face_width;  ///< [m]
};

constexpr auto tilt_members = std::to_array<Member<TiltOfPair>>({
    {"misalignment_under_load", "", "m",
     "by how much the static force makes the flanks part over the face, towards positive y, beside gear.misalignment",
     [](const TiltOfPair& of) -> Summary { return of.tilt.slope() * of.face_width; }},
    {"tilt_pinion", "", "rad", "part of the pinion's shaft in it, over the face width",
     [](const TiltOfPair& of) -> Summary { return of.tilt.slopes[0]; }},
    {"tilt_wheel", "", "rad", "part of the wheel's shaft",
     [](const TiltOfPair& of) -> Summary { return of.tilt.slopes[1]; }},
    {"tilting_moment_dry", "", "N m",
     "moment of the dry contact at the pitch point about the middle of the face, which turns the shafts back",
     [](const TiltOfPair& of) -> Summary { return of.tilt.moment; }},
});

}  // namespace

void add_tilt(const CaseInput& problem, Summary& summary) {
  if (problem.pair.tilt)
    add_members(tilt_members, TiltOfPair{*problem.pair.tilt, problem.pair.gears->face_width}, summary);
}

std::string tilt_line(const CaseInput& problem) {
  if (!problem.pair.tilt) return {};
  const ShaftTilt& tilt = *problem.pair.tilt;
  return worded(std::setprecision(4), "the static force tilts the shafts: the flanks part by ",
                1e6 * tilt.slope() * problem.pair.gears->face_width, " um over the face, by ", 1e6 * tilt.slopes[0],
                " urad of the pinion and ", 1e6 * tilt.slopes[1], " urad of the wheel");
}

std::string tilt_markdown() {
  return members_markdown("Shafts that tilt under load",
                          "Keys of summaries of a pair with a gear on two bearings at a distance.", tilt_members);
}

}  // namespace gearfilm
