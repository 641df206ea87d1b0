#include "results/wear_result.hpp"

#include <cmath>

#include "output/results_table.hpp"
#include "results/members.hpp"

namespace gearfilm {
namespace {

constexpr auto worn_members = std::to_array<Member<WornPair>>({
    {"revolutions", "N", "-", "revolutions of the pinion so far",
     [](const WornPair& worn) -> Summary { return worn.revolutions(); }, Column::real},
    {"roughness", "sigma", "m", "roughness of both flanks together, as it has run in",
     [](const WornPair& worn) -> Summary { return worn.roughness(); }, Column::real},
    {"worn_depth_pinion", "", "m", "largest depth that the pinion's flanks have lost",
     [](const WornPair& worn) -> Summary { return worn.largest_depth(0); }, Column::real},
    {"worn_depth_wheel", "", "m", "the same of the wheel",
     [](const WornPair& worn) -> Summary { return worn.largest_depth(1); }, Column::real},
    {"worn_volume_pinion", "", "m^3", "volume that a tooth of the pinion has lost",
     [](const WornPair& worn) -> Summary { return worn.volume(0); }, Column::real},
    {"worn_volume_wheel", "", "m^3", "the same of the wheel",
     [](const WornPair& worn) -> Summary { return worn.volume(1); }, Column::real},
});

/// Of the mesh on flanks that have worn so far, beside them in /wear/steps.
constexpr std::array<const char*, 6> mesh_columns = {
    "asperity_load_share_mean", "asperity_load_share_max",   "h_min",
    "force_ratio_max",          "mean_friction_coefficient", "efficiency"};

struct PlaceOnFlank {
  const WornPair& worn;
  std::size_t gear;
  double base_radius;
  int k, j;
};

constexpr auto worn_place_members = std::to_array<Member<PlaceOnFlank>>({
    {"s", "s", "m", "length of the involute from its base circle",
     [](const PlaceOnFlank& at) -> Summary { return at.worn.places(at.gear).s(at.k); }, Column::real},
    {"roll_angle", "", "rad", "roll angle there",
     [](const PlaceOnFlank& at) -> Summary {
       return std::sqrt(2.0 * at.worn.places(at.gear).s(at.k) / at.base_radius);
     },
     Column::real},
    {"y", "y", "m", "place across the face, from its middle",
     [](const PlaceOnFlank& at) -> Summary { return at.worn.places(at.gear).y(at.j); }, Column::real},
    {"depth", "", "m", "depth that has been lost",
     [](const PlaceOnFlank& at) -> Summary { return at.worn.depth(at.gear, at.k, at.j); }, Column::real},
});

}  // namespace

Summary worn_summary(const WornPair& worn) { return as_summary(worn_members, worn); }

Summary period_wear_summary(const PeriodWear& period, double revolutions) {
  return {{"step_revolutions", revolutions},
          {"asperity_work", period.work},
          {"lost_pinion", period.volumes[0]},
          {"lost_wheel", period.volumes[1]}};
}

PeriodWear read_period_wear(const Summary& step) {
  return {{step["lost_pinion"].get<FlankVolumes>(), step["lost_wheel"].get<FlankVolumes>()},
          step["asperity_work"].get<double>()};
}

void write_wear(ResultsFile& file, const Summary& steps, const WornPair& worn,
                const std::array<double, 2>& base_radii) {
  std::vector<TableColumn> columns = columns_of(worn_members);
  for (const char* name : mesh_columns) columns.push_back({name, std::string(name) == "h_min" ? "m" : "-"});
  std::vector<double> rows;
  for (const Summary& step : steps) {
    for (const TableColumn& column : columns) rows.push_back(in_row(step.value(column.name, Summary())));
  }
  write_table(file, "/wear/steps", columns, rows);
  for (std::size_t gear : {0, 1}) {
    std::vector<double> depths;
    const FlankPlaces& places = worn.places(gear);
    for (int k = 0; k < places.along; ++k) {
      for (int j = 0; j < places.across; ++j)
        add_to_row(worn_place_members, PlaceOnFlank{worn, gear, base_radii[gear], k, j}, depths);
    }
    write_table(file, gear == 0 ? "/wear/pinion" : "/wear/wheel", columns_of(worn_place_members), depths);
  }
}

std::string wear_markdown() {
  return members_markdown(
             "Steps of `wear`",
             "Keys of each of the `steps` of `wear`, with those of a periodic state, when the step begins.",
             worn_members, "`/wear/steps`") +
         members_markdown("Places on worn flanks", "At the end of `wear`.", worn_place_members,
                          "`/wear/pinion` and `/wear/wheel`");
}

}  // namespace gearfilm
