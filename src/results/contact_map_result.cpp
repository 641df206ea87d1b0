#include "results/contact_map_result.hpp"

#include <array>
#include <sstream>

namespace gearfilm {
namespace {

struct MapDataset {
  const char* name;
  const char* unit;
  std::vector<double> ContactMap::*values;
  bool over_face;  ///< points times rows
  const char* meaning;
};

constexpr std::array datasets = {
    MapDataset{"s", "m", &ContactMap::s, false, "points along the flank, from the base circle"},
    MapDataset{"xi", "m", &ContactMap::xi, false, "place of the contact that has the point in its middle"},
    MapDataset{"rho", "m", &ContactMap::radius, false, "radius of curvature there"},
    MapDataset{"y", "m", &ContactMap::y, false, "rows of the films across the face"},
    MapDataset{"p_max", "Pa", &ContactMap::pressure, true, "largest pressure"},
    MapDataset{"h_min", "m", &ContactMap::film, true, "smallest film"},
    MapDataset{"sliding_distance", "m", &ContactMap::sliding, true,
               "way that the other flank slides in a passage under more than 0.01 p_h"},
    MapDataset{
        "friction_energy", "J/m^2", &ContactMap::energy, true,
        "heat of sliding in a passage, with `friction.law`; the group's attribute `friction_energy_beyond` has what "
        "arises beyond both ends of the flank [J]"},
    MapDataset{"temperature_max", "K", &ContactMap::temperature, true,
               "highest temperature of the surface, with `thermal.model`"}};

}  // namespace

void write_contact_maps(ResultsFile& file, const ContactMapPair& maps) {
  constexpr std::array groups = {"/flank/pinion", "/flank/wheel"};
  for (std::size_t body = 0; body < maps.size(); ++body) {
    const ContactMap& map = maps[body];
    for (const MapDataset& dataset : datasets) {
      const std::vector<double>& values = map.*dataset.values;
      if (values.empty()) continue;
      const int columns = dataset.over_face ? static_cast<int>(map.y.size()) : 1;
      file.rows(groups[body], dataset.name, dataset.unit, static_cast<int>(values.size()) / columns, columns, values);
    }
    if (!map.energy.empty()) {
      file.attribute(groups[body], "friction_energy_beyond", map.energy_beyond);
    }
  }
}

std::string contact_map_markdown() {
  std::ostringstream text;
  text
      << "\n## Maps of flanks\n\n"
         "`/flank/pinion` and `/flank/wheel` of `periodic` and of `transient` on films. Over points and rows stands "
         "what\n"
         "films have done to the surfaces, in the periodic state or in the whole march, a passage being the mean over\n"
         "its mesh periods; not a number where no contact has been. Numbers are those of the film.\n\n"
         "| Dataset | Unit | Meaning |\n|---|---|---|\n";
  for (const MapDataset& dataset : datasets) {
    text << "| `" << dataset.name << "` | " << dataset.unit << " | " << dataset.meaning << " |\n";
  }
  return text.str();
}

}  // namespace gearfilm
