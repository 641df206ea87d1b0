// Stresses in both bodies in the section beneath one row of a film, y = Y along x, at some depths.
//
// A body has on its surface the film's pressure and a shear along x. With row spectra P_j, Q_j and the stresses
// K^P_j, K^Q_j that unit loads on the cells of row j make in the section (strip_spectra.hpp)
//   sigma(k; z) = sum_j [ K^P_j(k; z) P_j(k) + K^Q_j(k; z) Q_j(k) ] ,
// exact for loads that are constant on cells, and without transforms in y. Lines are padded, so that nothing comes
// round from their other end. Where rows are mirrored, those of their images are part of K, and in the row of symmetry
// yz = xy = 0.
//
// Every process sums over its own rows; sums are added depth by depth on the process that keeps the depth. In units of
// p_h and a.
#pragma once

#include "stress/surface_loads.hpp"

namespace gearfilm {

struct RowStressOptions {
  int row = 0;                   ///< of the stored rows, beneath which the section lies
  std::vector<double> depths{};  ///< [a], increasing
  std::array<double, body_count> poisson_ratio{};
  double reach = 2.5;  ///< how far the section extends at least to either side of x = 0 [a]

  bool operator==(const RowStressOptions&) const = default;
};

/// Of both bodies.
using SectionStresses = std::array<SectionStress, body_count>;

class RowStress {
public:
  RowStress(const Grid& grid, const RowStressOptions& options);

  const SectionLines& lines() const { return lines_; }
  const RowStressOptions& options() const { return options_; }
  const std::vector<double>& depths() const { return options_.depths; }
  /// yz = xy = 0: the section lies in a row of symmetry.
  bool symmetric() const { return symmetric_; }
  /// Depths that each process keeps, and those of this one.
  std::span<const int> depth_ranges() const { return depth_ranges_; }
  RowRange own_depths() const { return {depth_ranges_[rank_], depth_ranges_[rank_ + 1]}; }
  MPI_Comm comm() const { return comm_; }

  /// At the own depths. Collective.
  const SectionStresses& evaluate(const SurfaceLoads& loads);

private:
  /// Of one body, by depth (RowKernels).
  struct OfBody {
    std::vector<double> pressure, shear;
  };

  MPI_Comm comm_;
  int rank_;
  RowStressOptions options_;
  SectionLines lines_;
  LoadSpectra spectra_;
  std::vector<int> depth_ranges_;
  bool symmetric_;  ///< the section lies in a row of symmetry
  std::size_t kernel_size_ = 0;
  std::vector<OfBody> kernels_;  ///< one for both bodies where they have the same Poisson ratio
  std::vector<double> sums_;     ///< of own rows at all depths
  std::vector<double> whole_;    ///< of all rows at own depths
  SectionStresses result_;
};

}  // namespace gearfilm
