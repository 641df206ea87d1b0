#include "stress/row_stress.hpp"

#include <algorithm>

#include "stress/place_sums.hpp"
#include "stress/row_kernels.hpp"

namespace gearfilm {

RowStress::RowStress(const Grid& grid, const RowStressOptions& options)
    : comm_(grid.comm()),
      rank_(grid.rank()),
      options_(options),
      lines_(grid.shape(), options.reach),
      spectra_(grid, lines_),
      depth_ranges_(cut_evenly(static_cast<int>(options.depths.size()), grid.processes())),
      symmetric_(options.row == grid.row_axis().mirror_row()),
      sums_(depths().size() * spectra_.sum_size()),
      whole_(own_depths().count() * spectra_.sum_size()) {
  for (SectionStress& body : result_) body = SectionStress(own_depths().count(), lines_.count);
  const auto& ratio = options.poisson_ratio;
  kernels_.resize(ratio[pinion_body] == ratio[wheel_body] ? 1 : body_count);
  RowKernels kernels(grid, spectra_.lattice());
  kernel_size_ = kernels.size();
  for (std::size_t body = 0; body < kernels_.size(); ++body) {
    for (const auto& [load, values] : {std::pair{SurfaceLoad::pressure, &kernels_[body].pressure},
                                       std::pair{SurfaceLoad::shear_x, &kernels_[body].shear}}) {
      values->resize(depths().size() * kernel_size_);
      for (std::size_t k = 0; k < depths().size(); ++k) {
        kernels.at(grid.row_axis().y(options.row), depths()[k], load, ratio[body],
                   std::span(*values).subspan(k * kernel_size_, kernel_size_));
      }
    }
  }
}

const SectionStresses& RowStress::evaluate(const SurfaceLoads& loads) {
  spectra_.transform(loads);
  const std::size_t size = spectra_.sum_size();
  for (std::size_t depth = 0; depth < depths().size(); ++depth) {
    const auto of_body = [&](const OfBody& body) {
      return PlaceKernels{body.pressure.data() + depth * kernel_size_, body.shear.data() + depth * kernel_size_};
    };
    spectra_.sum({of_body(kernels_.front()), of_body(kernels_.back())}, symmetric_,
                 std::span(sums_).subspan(depth * size, size));
  }
  distribute_sums(comm_, depth_ranges_, size, sums_, whole_);
  for (int depth = 0; depth < own_depths().count(); ++depth) {
    spectra_.transform_back(std::span<const double>(whole_).subspan(depth * size, size), result_, depth);
  }
  return result_;
}

}  // namespace gearfilm
