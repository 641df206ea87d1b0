#include "stress/row_stress.hpp"

#include <algorithm>

#include "stress/place_sums.hpp"

namespace gearfilm {

RowStress::RowStress(const Grid& grid, const RowStressOptions& options)
    : comm_(grid.comm()),
      rank_(grid.rank()),
      options_(options),
      lines_(grid.shape(), options.reach),
      spectra_(grid, lines_),
      depth_ranges_(cut_evenly(static_cast<int>(options.depths.size()), grid.processes())),
      mirror_row_(grid.row_axis().mirror_row()),
      sums_(depths().size() * spectra_.sum_size()),
      whole_(own_depths().count() * spectra_.sum_size()) {
  const SectionStress section(own_depths().count(), lines_.count);
  result_.assign(options.rows.size(), {section, section});
  RowKernels kernels(grid, spectra_.lattice());
  kernel_size_ = kernels.size();
  for (const int row : options.rows) make_kernels(kernels, grid.row_axis().y(row), kernels_.emplace_back());
}

void RowStress::make_kernels(RowKernels& kernels, double y, std::vector<OfBody>& of_bodies) const {
  const auto& ratio = options_.poisson_ratio;
  of_bodies.resize(ratio[pinion_body] == ratio[wheel_body] ? 1 : body_count);
  for (std::size_t body = 0; body < of_bodies.size(); ++body) {
    for (const auto& [load, values] : {std::pair{SurfaceLoad::pressure, &of_bodies[body].pressure},
                                       std::pair{SurfaceLoad::shear_x, &of_bodies[body].shear}}) {
      values->resize(depths().size() * kernel_size_);
      for (std::size_t k = 0; k < depths().size(); ++k) {
        kernels.at(y, depths()[k], load, ratio[body], std::span(*values).subspan(k * kernel_size_, kernel_size_));
      }
    }
  }
}

const std::vector<SectionStresses>& RowStress::evaluate(const SurfaceLoads& loads) {
  spectra_.transform(loads);
  for (std::size_t section = 0; section < result_.size(); ++section) evaluate_section(section);
  return result_;
}

void RowStress::evaluate_section(std::size_t section) {
  const std::size_t size = spectra_.sum_size();
  for (std::size_t depth = 0; depth < depths().size(); ++depth) {
    const auto of_body = [&](const OfBody& body) {
      return PlaceKernels{body.pressure.data() + depth * kernel_size_, body.shear.data() + depth * kernel_size_};
    };
    spectra_.sum({of_body(kernels_[section].front()), of_body(kernels_[section].back())}, symmetric(section),
                 std::span(sums_).subspan(depth * size, size));
  }
  distribute_sums(comm_, depth_ranges_, size, sums_, whole_);
  for (int depth = 0; depth < own_depths().count(); ++depth) {
    spectra_.transform_back(std::span<const double>(whole_).subspan(depth * size, size), symmetric(section),
                            result_[section], depth);
  }
}

}  // namespace gearfilm
