// Stresses in both bodies in the sections beneath some rows of a film, y = Y along x, at some depths.
//
// A body has on its surface the film's pressure and a shear along x. With row spectra P_j, Q_j and the stresses
// K^P_j, K^Q_j that unit loads on the cells of row j make in a section (strip_spectra.hpp)
//   sigma(k; z) = sum_j [ K^P_j(k; z) P_j(k) + K^Q_j(k; z) Q_j(k) ] ,
// exact for loads that are constant on cells, and without transforms in y. Lines are padded, so that nothing comes
// round from their other end. Where rows are mirrored, those of their images are part of K, and in the row of symmetry
// yz = xy = 0.
//
// Every process sums over its own rows; sums are added depth by depth on the process that keeps the depth. In units of
// p_h and a.
#pragma once

#include "stress/row_kernels.hpp"
#include "stress/surface_loads.hpp"

namespace gearfilm {

struct RowStressOptions {
  std::vector<int> rows{0};      ///< of the stored rows, beneath which the sections lie
  std::vector<double> depths{};  ///< [a], increasing
  std::array<double, body_count> poisson_ratio{};
  double reach = 2.5;  ///< how far sections extend at least to either side of x = 0 [a]

  bool operator==(const RowStressOptions&) const = default;
};

/// The sections of both bodies.
using SectionStresses = std::array<SectionStress, body_count>;

class RowStress {
public:
  RowStress(const Grid& grid, const RowStressOptions& options);

  const SectionLines& lines() const { return lines_; }
  const RowStressOptions& options() const { return options_; }
  const std::vector<double>& depths() const { return options_.depths; }
  /// yz = xy = 0: a section, by its number among the options' rows, lies in a row of symmetry.
  bool symmetric(std::size_t section) const { return options_.rows[section] == mirror_row_; }
  /// Depths that each process keeps, and those of this one.
  std::span<const int> depth_ranges() const { return depth_ranges_; }
  RowRange own_depths() const { return {depth_ranges_[rank_], depth_ranges_[rank_ + 1]}; }
  MPI_Comm comm() const { return comm_; }

  /// Stresses below each of the options' rows, at the depths of this process. Collective.
  const std::vector<SectionStresses>& evaluate(const SurfaceLoads& loads);

private:
  /// The kernels of one body, by depth (RowKernels).
  struct OfBody {
    std::vector<double> pressure, shear;
  };

  void make_kernels(RowKernels& kernels, double y, std::vector<OfBody>& of_bodies) const;
  void evaluate_section(std::size_t section);

  MPI_Comm comm_;
  int rank_;
  RowStressOptions options_;
  SectionLines lines_;
  LoadSpectra spectra_;
  std::vector<int> depth_ranges_;
  int mirror_row_;
  std::size_t kernel_size_ = 0;
  std::vector<std::vector<OfBody>> kernels_;  ///< by section; one for both bodies that have the same Poisson ratio
  std::vector<double> sums_;                  ///< of own rows at all depths of a section
  std::vector<double> whole_;                 ///< of all rows at own depths
  std::vector<SectionStresses> result_;
};

}  // namespace gearfilm
