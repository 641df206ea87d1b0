#include "gearfilm/dynamics/live_heat.hpp"

namespace gearfilm {
namespace {

std::string name_of(int point) { return std::string(field::heat) + std::to_string(point); }

}  // namespace

void keep_heat(const TractionModel& model, const FilmHeat& heat, std::size_t rows, ContactFields& fields) {
  if (model.heats_film()) {
    const ThermalOil& oil = model.heat->oil;
    const std::size_t points = model.heat->points;
    for (std::size_t k = 0; k < points; ++k) {
      std::vector<double>& values = fields[name_of(static_cast<int>(k))];
      values.resize(heat.flow.entrainment_excess.size());
      for (std::size_t i = 0; i * rows < values.size(); ++i) {
        const double* T = heat.temperatures.data() + rows_at_point(i, k, points, rows);
        for (std::size_t j = 0; j < rows; ++j) {
          values[i * rows + j] = oil.temperature_viscosity * (T[j] - oil.temperature);
        }
      }
    }
  }
  for (const auto& known : field::correction) fields[std::string(known.field.name)] = heat.flow.*known.values;
}

FilmHeat kept_heat(const TractionModel& model, const ContactFields& fields, std::size_t rows) {
  FilmHeat heat;
  for (const auto& known : field::correction) heat.flow.*known.values = values_of(fields, known.field);
  heat.flow.shear_power = thinning_power(model.law);
  heat.flow.sheared = model.shear_couples_film;
  if (!model.heats_film()) return heat;
  const ThermalOil& oil = model.heat->oil;
  const std::size_t points = model.heat->points;
  heat.temperatures.resize(heat.flow.entrainment_excess.size() * points);
  for (std::size_t k = 0; k < points; ++k) {
    const std::vector<double>& values = fields.at(name_of(static_cast<int>(k)));
    for (std::size_t i = 0; i * rows < values.size(); ++i) {
      double* T = heat.temperatures.data() + rows_at_point(i, k, points, rows);
      for (std::size_t j = 0; j < rows; ++j) T[j] = oil.temperature + values[i * rows + j] / oil.temperature_viscosity;
    }
  }
  return heat;
}

}  // namespace gearfilm
