// What unit loads on the rows of a grid make at a place in a body, by wave numbers along x.
#pragma once

#include "grid/grid.hpp"
#include "stress/strip_spectra.hpp"

namespace gearfilm {

class RowKernels {
public:
  RowKernels(const Grid& grid, const StripLattice& lattice);

  /// [component][own row][wave], with the factor of the inverse transform.
  std::size_t size() const { return stress_components * own_.size() * lattice_.waves(); }
  /// Kernels at the place y and the depth z [a], the images of mirrored rows included.
  void at(double y, double z, SurfaceLoad load, double poisson_ratio, std::span<double> kernels);

private:
  std::vector<std::vector<Strip>> own_;  ///< cells of each own row, and of its image
  StripLattice lattice_;
  StripSpectra transform_;
};

}  // namespace gearfilm
