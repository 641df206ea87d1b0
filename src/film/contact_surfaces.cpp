#include "film/contact_surfaces.hpp"

#include "film/contact_film.hpp"
#include "film/transfer.hpp"

namespace gearfilm {

namespace {

/// Adds what flanks lack beside the middle of their faces.
void open_beside_middle(const Grid& grid, const Scales& scales, const UnevenProfile& profile,
                        std::vector<double>& gap) {
  const auto rows = static_cast<std::size_t>(grid.y_count());
  std::vector<double> y(rows);
  for (std::size_t j = 0; j < rows; ++j) y[j] = grid.y(static_cast<int>(j)) * scales.length;
  std::vector<double> added;
  for (int i = 0; i < grid.nx(); ++i) {
    if (i == 0 || profile.along) added = profile.gap(grid.x(i) * scales.length, y);
    double* line = gap.data() + static_cast<std::size_t>(i) * rows;
    for (std::size_t j = 0; j < rows; ++j) line[j] += added[j] / scales.thickness;
  }
}

/// Takes the heights of both flanks from the gap.
void take_texture_off(const Grid& grid, const Scales& scales, const ContactTexture& texture, std::vector<double>& gap) {
  const auto rows = static_cast<std::size_t>(grid.y_count());
  std::vector<double> across(rows);
  for (int j = 0; j < grid.y_count(); ++j)
    across[static_cast<std::size_t>(j)] = texture.across(grid.y(j) * scales.length) / scales.thickness;
  for (int i = 0; i < grid.nx(); ++i) {
    const auto [pinion, wheel] = texture.along(grid.x(i) * scales.length);
    const double along = (pinion.value + wheel.value) / scales.thickness;
    double* line = gap.data() + static_cast<std::size_t>(i) * rows;
    for (std::size_t j = 0; j < rows; ++j) line[j] -= along + across[j];
  }
}

}  // namespace

ContactSurfaces surfaces_of(const Grid& grid, const Scales& scales, const ContactConditions& conditions) {
  const auto rows = static_cast<std::size_t>(grid.y_count());
  ContactSurfaces surfaces{.conditions = conditions,
                           .gap = std::vector<double>(grid.local_size()),
                           .entrainment = std::vector<double>(rows, conditions.entrainment),
                           .sliding = std::vector<double>(rows, conditions.sliding),
                           .of_conditions = true};
  for (int i = 0; i < grid.nx(); ++i) {
    const double x = grid.x(i);
    const double along = conditions.gap_offset + 0.5 * x * x / conditions.relative_radius +
                         conditions.local(x * scales.length) / scales.thickness;
    double* line = surfaces.gap.data() + static_cast<std::size_t>(i) * rows;
    for (int j = 0; j < grid.y_count(); ++j) line[j] = along + 0.5 * scales.radius_ratio * grid.y(j) * grid.y(j);
    if (!scales.solids.face) continue;
    for (int j = 0; j < grid.y_count(); ++j)
      line[j] += (*scales.solids.face)(grid.y(j) * scales.length) / scales.thickness;
  }
  if (conditions.beside_middle.flanks) open_beside_middle(grid, scales, conditions.beside_middle, surfaces.gap);
  if (!conditions.texture.flanks) return surfaces;
  take_texture_off(grid, scales, conditions.texture, surfaces.gap);
  surfaces.heights = carried_heights(grid, scales, conditions);
  return surfaces;
}

ContactSurfaces injected_surfaces(const Grid& fine_grid, const Grid& coarse_grid, const ContactSurfaces& fine) {
  Field<double> gap(fine_grid), coarse_gap(coarse_grid);
  gap.load(fine.gap);
  inject(fine_grid, coarse_grid, gap, coarse_gap);
  ContactSurfaces coarse{.conditions = fine.conditions,
                         .gap = std::vector<double>(coarse_grid.local_size()),
                         .entrainment = {},
                         .sliding = {},
                         .of_conditions = fine.of_conditions};
  coarse_gap.store(coarse.gap);
  for (int J = 0; J < coarse_grid.y_count(); ++J) {
    const auto j = static_cast<std::size_t>(injected_row(fine_grid, coarse_grid, J));
    coarse.entrainment.push_back(fine.entrainment[j]);
    coarse.sliding.push_back(fine.sliding[j]);
  }
  return coarse;
}

void move_surfaces(ContactFilm& film, const ContactConditions& conditions) {
  if (film.surfaces().of_conditions && film.conditions() == conditions) return;
  film.set_surfaces(surfaces_of(film.grid(), film.scales(), conditions));
}

}  // namespace gearfilm
