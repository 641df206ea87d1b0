// Transforms along x of the stresses beneath cells of a strip, for sums over rows wave number by wave number.
//
// Beneath a cell under pressure xx, yy, zz and yz are even in x and xz and xy odd; under a shear q_x it is the other
// way round. Transforms of what is even are real, of what is odd imaginary: the factor of i is kept here.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "elasticity/fftw.hpp"
#include "stress/patch_kernel.hpp"

namespace gearfilm {

/// Whether the transform of a component is imaginary.
constexpr bool is_odd_in_x(SurfaceLoad load, std::size_t component) {
  return (component >= 4) == (load == SurfaceLoad::pressure);
}

/// Cells of a strip: their width, and over how many of them stresses reach; the length of lines that are convolved.
struct StripLattice {
  double h_x = 0.0;
  int reach = 0;
  int length = 0;  ///< > 2 reach

  int waves() const { return length / 2 + 1; }
};

class StripSpectra {
public:
  explicit StripSpectra(const StripLattice& lattice);

  /// Adds to K(k) of each component, [component][waves()], those of cells in a strip of y relative to the place;
  /// nu: Poisson's ratio.
  void add(SurfaceLoad load, const Strip& strip, double z, double nu, std::span<double> spectra);

private:
  StripLattice lattice_;
  fftw::Buffer<double> line_;
  fftw::Buffer<std::complex<double>> wave_;
  fftw::Plan<double> forward_;
  std::vector<std::array<double, stress_components>> corners_;  ///< differences across the strip at edges of cells
};

}  // namespace gearfilm
