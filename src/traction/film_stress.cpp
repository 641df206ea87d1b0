#include "traction/film_stress.hpp"

#include <algorithm>

#include "film/face_quantities.hpp"
#include "stress/stress_field.hpp"

namespace gearfilm {
namespace {

std::vector<double> compact(const Field<double>& field) {
  std::vector<double> values(static_cast<std::size_t>(field.nx()) * field.y_count());
  field.store(values);
  return values;
}

BodyStress in_si(const Scales& scales, const StressFigures& figures) {
  const double p = scales.pressure, a = scales.length;
  return {.von_mises = p * figures.von_mises.value,
          .von_mises_depth = a * figures.von_mises.at,
          .shear = p * figures.largest_shear.value,
          .shear_depth = a * figures.largest_shear.at,
          .orthogonal_shear = p * figures.orthogonal_shear.value,
          .orthogonal_shear_depth = a * figures.orthogonal_shear.at,
          .surface_tension = p * figures.surface_tension};
}

}  // namespace

RowStressOptions row_options(const StressModel& model, int row) {
  return {.row = row, .depths = model.depths, .poisson_ratio = model.poisson_ratio};
}

SurfaceLoads loads_below(const Scales& scales, const Grid& grid, const LoadingFields& fields,
                         std::span<const double> shear_stress) {
  std::vector<double> half_gap = compact(fields.gap), shear(shear_stress.begin(), shear_stress.end());
  for (double& value : half_gap) value *= 0.5 * scales.thickness / scales.length;
  for (double& value : shear) value /= scales.pressure;
  return surface_loads(grid, {compact(fields.total_pressure), compact(fields.film_pressure)}, half_gap, shear);
}

SurfaceLoads loads_below(const ContactFilm& film, std::span<const double> shear_stress) {
  return loads_below(film.scales(), film.grid(), {film.total_pressure(), film.film_pressure(), film.mean_gap()},
                     shear_stress);
}

int most_loaded_row(const ContactFilm& film) {
  const RowAxis& rows = film.grid().row_axis();
  if (!film.scales().solids.face) return rows.central();
  const std::vector<double> loads = face_quantities(film).line_load;
  const auto most = std::ranges::max_element(loads) - loads.begin();
  return rows.stored_row(static_cast<int>(most));
}

FilmSection film_section(const StressModel& model, const ContactFilm& film, std::span<const double> shear_stress,
                         int row) {
  RowStress& below = film.discretisation()->prepare_stress(row_options(model, row));
  const SectionStresses& stresses = below.evaluate(loads_below(film, shear_stress));
  return {&below, &stresses, stress_profiles(below, stresses)};
}

std::array<SectionRecord, body_count> section_records(const Scales& scales, const FilmSection& section, double xi) {
  const SectionLines& lines = section.row->lines();
  const SectionPlaces places{scales.length * lines.first, scales.length * lines.step, lines.count};
  const auto of = [&](std::size_t body) {
    return section_record(xi, places, (*section.stresses)[body], scales.pressure, section.row->symmetric());
  };
  return {of(pinion_body), of(wheel_body)};
}

ContactStress contact_stress(const Scales& scales, const FilmSection& section) {
  ContactStress both;
  for (std::size_t body = 0; body < body_count; ++body) {
    both[body] = in_si(scales, stress_figures(section.profiles[body], section.row->depths()));
  }
  return both;
}

WholeSection whole_section(const Scales& scales, const FilmSection& section) {
  const RowStress& row = *section.row;
  WholeSection whole;
  for (int line = 0; line < row.lines().count; ++line) whole.x.push_back(scales.length * row.lines().x(line));
  for (const double depth : row.depths()) whole.z.push_back(scales.length * depth);
  const std::size_t size = row.lines().count * stress_components;
  std::vector<int> counts, offsets;
  for (std::size_t rank = 0; rank + 1 < row.depth_ranges().size(); ++rank) {
    offsets.push_back(static_cast<int>(row.depth_ranges()[rank] * size));
    counts.push_back(static_cast<int>((row.depth_ranges()[rank + 1] - row.depth_ranges()[rank]) * size));
  }
  for (std::size_t body = 0; body < body_count; ++body) {
    const SectionStress& own = (*section.stresses)[body];
    std::vector<double> values, all(row.depths().size() * size);
    for (int depth = 0; depth < own.depths(); ++depth) {
      for (int line = 0; line < own.lines(); ++line) {
        const auto components = (scales.pressure * own.at(depth, line)).components();
        values.insert(values.end(), components.begin(), components.end());
      }
    }
    MPI_Gatherv(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, all.data(), counts.data(), offsets.data(),
                MPI_DOUBLE, 0, row.comm());
    for (std::size_t n = 0; n < all.size(); n += stress_components) {
      whole.stress[body].push_back({all[n], all[n + 1], all[n + 2], all[n + 3], all[n + 4], all[n + 5]});
    }
  }
  return whole;
}

std::array<std::vector<double>, body_count> von_mises_fields(const StressModel& model, const ContactFilm& film,
                                                             std::span<const double> shear_stress, int row) {
  const FilmSection section = film_section(model, film, shear_stress, row);
  const SurfaceLoads loads = loads_below(film, shear_stress);
  std::array<std::vector<double>, body_count> fields;
  for (std::size_t body = 0; body < body_count; ++body) {
    const double depth = stress_figures(section.profiles[body], section.row->depths()).von_mises.at;
    for (const Stress& stress : stress_field(film.grid(), loads, depth, model.poisson_ratio)[body]) {
      fields[body].push_back(film.scales().pressure * von_mises(stress));
    }
  }
  return fields;
}

}  // namespace gearfilm
