#include "gearfilm/dynamics/live_heat.hpp"

namespace gearfilm {
namespace {

std::string name_of(int point) { return std::string(field::heat) + std::to_string(point); }

}  // namespace

void keep_heat(const TractionModel& model, const FilmHeat& heat, ContactFields& fields) {
  const ThermalOil& oil = model.heat->oil;
  const std::size_t points = model.heat->points;
  for (std::size_t k = 0; k < points; ++k) {
    std::vector<double>& values = fields[name_of(static_cast<int>(k))];
    values.resize(heat.flow.wedge.size());
    for (std::size_t n = 0; n < values.size(); ++n) {
      values[n] = oil.temperature_viscosity * (heat.temperatures[n * points + k] - oil.temperature);
    }
  }
  fields[std::string(field::thinning.name)] = heat.flow.thinning;
  fields[std::string(field::wedge.name)] = heat.flow.wedge;
  fields[std::string(field::density.name)] = heat.flow.density;
}

FilmHeat kept_heat(const TractionModel& model, const ContactFields& fields) {
  const ThermalOil& oil = model.heat->oil;
  const std::size_t points = model.heat->points;
  FilmHeat heat;
  heat.flow = {values_of(fields, field::thinning), values_of(fields, field::wedge), values_of(fields, field::density)};
  heat.temperatures.resize(heat.flow.wedge.size() * points);
  for (std::size_t k = 0; k < points; ++k) {
    const std::vector<double>& values = fields.at(name_of(static_cast<int>(k)));
    for (std::size_t n = 0; n < values.size(); ++n) {
      heat.temperatures[n * points + k] = oil.temperature + values[n] / oil.temperature_viscosity;
    }
  }
  return heat;
}

}  // namespace gearfilm
