#include "traction/film_stress.hpp"

#include <algorithm>
#include <cmath>

#include "film/face_quantities.hpp"
#include "stress/place_sums.hpp"
#include "stress/stress_field.hpp"

namespace gearfilm {
namespace {

std::vector<double> compact(const Field<double>& field) {
  std::vector<double> values(static_cast<std::size_t>(field.nx()) * field.y_count());
  field.store(values);
  return values;
}

const Peak& larger(const Peak& a, const Peak& b) { return b.value > a.value ? b : a; }

/// Largest values of all sections in a body.
LargestStresses largest_in_sections(const FilmSections& sections, std::size_t body) {
  LargestStresses largest = largest_stresses(sections.profiles.front()[body], sections.rows->depths());
  for (const StressProfiles& profiles : sections.profiles) {
    const LargestStresses own = largest_stresses(profiles[body], sections.rows->depths());
    largest.von_mises = larger(largest.von_mises, own.von_mises);
    largest.largest_shear = larger(largest.largest_shear, own.largest_shear);
    largest.orthogonal_shear = larger(largest.orthogonal_shear, own.orthogonal_shear);
    largest.surface_tension = std::max(largest.surface_tension, own.surface_tension);
  }
  return largest;
}

BodyStress in_si(const Scales& scales, const LargestStresses& stresses) {
  const double p = scales.pressure, a = scales.length;
  return {.von_mises = p * stresses.von_mises.value,
          .von_mises_depth = a * stresses.von_mises.at,
          .shear = p * stresses.largest_shear.value,
          .shear_depth = a * stresses.largest_shear.at,
          .orthogonal_shear = p * stresses.orthogonal_shear.value,
          .orthogonal_shear_depth = a * stresses.orthogonal_shear.at,
          .surface_tension = p * stresses.surface_tension};
}

}  // namespace

std::vector<int> stress_rows(const StressModel& model, const RowAxis& axis) {
  const int middle = axis.nearest(model.most_loaded);
  std::vector<int> rows{middle};
  if (!model.all_rows) return rows;
  constexpr double round_off = 1e-9;
  const auto take = [&](int row) {
    const bool apart = std::abs(axis.y(row) - axis.y(rows.back())) >= model.row_distance * (1.0 - round_off);
    if (apart && !axis.is_ambient(row)) rows.push_back(row);
  };
  for (int row = middle - 1; row >= 0; --row) take(row);
  std::ranges::reverse(rows);
  for (int row = middle + 1; row < axis.count(); ++row) take(row);
  return rows;
}

RowStressOptions row_options(const StressModel& model, const std::vector<int>& rows) {
  return {.rows = rows, .depths = model.depths, .poisson_ratio = model.poisson_ratio};
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

FilmSections film_sections(const StressModel& model, const ContactFilm& film, std::span<const double> shear_stress,
                           const std::vector<int>& rows) {
  RowStress& below = film.discretisation()->prepare_stress(row_options(model, rows));
  FilmSections sections{&below, &below.evaluate(loads_below(film, shear_stress)), {}};
  for (const SectionStresses& section : *sections.stresses)
    sections.profiles.push_back(stress_profiles(below, section));
  return sections;
}

SectionRecords section_records(const Scales& scales, const RowStress& rows,
                               const std::vector<SectionStresses>& stresses, double xi) {
  const SectionLines& lines = rows.lines();
  const SectionPlaces places{scales.length * lines.first, scales.length * lines.step, lines.count};
  SectionRecords records;
  for (std::size_t row = 0; row < stresses.size(); ++row) {
    const auto of = [&](std::size_t body) {
      return section_record(xi, places, stresses[row][body], scales.pressure, rows.symmetric(row));
    };
    records.push_back({of(pinion_body), of(wheel_body)});
  }
  return records;
}

ContactStress contact_stress(const Scales& scales, const FilmSections& sections) {
  ContactStress both;
  for (std::size_t body = 0; body < body_count; ++body) both[body] = in_si(scales, largest_in_sections(sections, body));
  return both;
}

WholeSection whole_section(const Scales& scales, const FilmSections& sections) {
  const RowStress& row = *sections.rows;
  WholeSection whole;
  for (int line = 0; line < row.lines().count; ++line) whole.x.push_back(scales.length * row.lines().x(line));
  for (const double depth : row.depths()) whole.z.push_back(scales.length * depth);
  for (std::size_t body = 0; body < body_count; ++body) {
    const SectionStress& own = sections.stresses->front()[body];
    std::vector<Stress> values;
    for (int depth = 0; depth < own.depths(); ++depth) {
      for (int line = 0; line < own.lines(); ++line) values.push_back(scales.pressure * own.at(depth, line));
    }
    whole.stress[body] = gather_stresses(row.comm(), row.depth_ranges(), row.lines().count, values);
  }
  return whole;
}

std::array<std::vector<double>, body_count> von_mises_fields(const StressModel& model, const ContactFilm& film,
                                                             std::span<const double> shear_stress,
                                                             const std::vector<int>& rows) {
  const FilmSections sections = film_sections(model, film, shear_stress, rows);
  const SurfaceLoads loads = loads_below(film, shear_stress);
  std::array<std::vector<double>, body_count> fields;
  for (std::size_t body = 0; body < body_count; ++body) {
    const double depth = largest_in_sections(sections, body).von_mises.at;
    for (const Stress& stress : stress_field(film.grid(), loads, depth, model.poisson_ratio)[body]) {
      fields[body].push_back(film.scales().pressure * von_mises(stress));
    }
  }
  return fields;
}

}  // namespace gearfilm
