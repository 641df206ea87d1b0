#include "stress/section_stress.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

int lines_over(double length, double step) {
  return length > 0.0 ? static_cast<int>(std::ceil(length / step - 1e-9)) : 0;
}

}  // namespace

SectionLines::SectionLines(const GridShape& shape, double reach)
    : step(shape.h_x()),
      of_grid(shape.nx),
      before(lines_over(reach + shape.x_min, step)),
      count(before + shape.nx + lines_over(reach - shape.x_max, step)),
      first(shape.x_min - before * step) {}

StripLattice SectionLines::lattice() const {
  const int reach = of_grid - 1 + std::max(before, count - of_grid - before);
  return {step, reach, fftw::fast_length(2 * reach + 1)};
}

}  // namespace gearfilm
