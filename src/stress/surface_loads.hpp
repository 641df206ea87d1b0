// What a film does to the surfaces of both bodies, and the transforms of its rows along x.
//
//   pinion  q = -tau_m - (h/2) dp/dx        wheel  q = +tau_m - (h/2) dp/dx
// with tau_m the shear stress in the middle of the film and p the pressure of its oil. Both together are -h dp/dx, as
// forces on the film are. The shear across, (h/2) dp/dy, is below 1e-3 of the pressure and left out. In p_h and a.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "stress/section_stress.hpp"

namespace gearfilm {

/// The two bodies of a contact in arrays.
constexpr std::size_t pinion_body = 0, wheel_body = 1, body_count = 2;

/// Loads at the own nodes of a grid, [nx][own rows].
struct SurfaceLoads {
  std::vector<double> pressure;
  std::array<std::vector<double>, body_count> shear;  ///< q along x, on the body
};

/// What presses on the solids, and the part of it that the oil has.
struct FilmPressures {
  std::vector<double> total;
  std::vector<double> of_oil;
};

/// The loads of a film: its pressures, h/2 [a] and shear stress (empty: none).
SurfaceLoads surface_loads(const Grid& grid, FilmPressures pressures, std::span<const double> half_thickness,
                           std::span<const double> shear_stress);

/// What unit loads on the own rows make at one place: K(k) by [component][own row][wave].
struct PlaceKernels {
  const double* pressure;
  const double* shear;
};

class LoadSpectra {
public:
  LoadSpectra(const Grid& grid, const SectionLines& lines);

  const StripLattice& lattice() const { return lattice_; }
  void transform(const SurfaceLoads& loads);
  /// Numbers that the stresses of both bodies at one place are: [body][component][re, im][wave].
  std::size_t sum_size() const { return body_count * stress_components * 2 * lattice_.waves(); }
  /// Stresses at one place by the own rows. Where both bodies have the same kernels their pressures are summed once; in
  /// a row of symmetry yz and xy vanish.
  void sum(const std::array<PlaceKernels, body_count>& kernels, bool symmetric, std::span<double> sums) const;
  /// The lines of a section, of sums over all rows; yz and xy of a row of symmetry stay as they are.
  void transform_back(std::span<const double> sums, bool symmetric, std::array<SectionStress, body_count>& sections,
                      int place);

private:
  /// yz and xy.
  static constexpr bool is_across(std::size_t component) { return component == 3 || component == 5; }
  void add_rows(const double* kernel, std::size_t load, bool imaginary, double* sum) const;

  int own_rows_;
  SectionLines lines_;
  StripLattice lattice_;
  // Loads: pressure, and the shear on each body.
  fftw::Buffer<double> rows_;                   ///< [load][own row][length]
  fftw::Buffer<std::complex<double>> spectra_;  ///< [load][own row][wave]
  std::vector<double> loads_;                   ///< the same, [load][own row][re, im][wave]
  fftw::Buffer<std::complex<double>> wave_;     ///< of one line, and the line
  fftw::Buffer<double> line_;
  fftw::Plan<double> forward_, backward_;
};

}  // namespace gearfilm
