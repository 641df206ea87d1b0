#include "stress/stress_field.hpp"

#include "stress/place_sums.hpp"
#include "stress/row_kernels.hpp"

namespace gearfilm {

std::array<std::vector<Stress>, body_count> stress_field(const Grid& grid, const SurfaceLoads& loads, double depth,
                                                         const std::array<double, body_count>& poisson_ratio) {
  const SectionLines lines(grid.shape(), 0.0);
  LoadSpectra spectra(grid, lines);
  RowKernels kernels(grid, spectra.lattice());
  spectra.transform(loads);
  const std::size_t size = spectra.sum_size(), rows = grid.row_axis().count(), own = grid.y_count();
  std::vector<double> sums(rows * size), whole(own * size);
  std::array<std::vector<double>, body_count> pressure, shear;
  const bool alike = poisson_ratio[pinion_body] == poisson_ratio[wheel_body];
  const std::size_t different = alike ? 1 : body_count;
  for (std::size_t row = 0; row < rows; ++row) {
    const double y = grid.row_axis().y(static_cast<int>(row));
    for (std::size_t body = 0; body < different; ++body) {
      pressure[body].resize(kernels.size());
      shear[body].resize(kernels.size());
      kernels.at(y, depth, SurfaceLoad::pressure, poisson_ratio[body], pressure[body]);
      kernels.at(y, depth, SurfaceLoad::shear_x, poisson_ratio[body], shear[body]);
    }
    const std::size_t last = different - 1;
    spectra.sum(
        {PlaceKernels{pressure[0].data(), shear[0].data()}, PlaceKernels{pressure[last].data(), shear[last].data()}},
        static_cast<int>(row) == grid.row_axis().mirror_row(), std::span(sums).subspan(row * size, size));
  }
  distribute_sums(grid.comm(), grid.y_ranges(), size, sums, whole);
  SectionStresses sections{SectionStress(static_cast<int>(own), lines.count),
                           SectionStress(static_cast<int>(own), lines.count)};
  std::array<std::vector<Stress>, body_count> field;
  for (std::size_t j = 0; j < own; ++j) {
    spectra.transform_back(std::span<const double>(whole).subspan(j * size, size), false, sections,
                           static_cast<int>(j));
  }
  for (std::size_t body = 0; body < body_count; ++body) {
    for (int i = 0; i < lines.count; ++i) {
      for (std::size_t j = 0; j < own; ++j) field[body].push_back(sections[body].at(static_cast<int>(j), i));
    }
  }
  return field;
}

}  // namespace gearfilm
