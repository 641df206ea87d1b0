// What rough surfaces make of the gap H of their mean planes, at every node.
//
//   P_f = P - P_a(H)          pressure of the oil: asperities carry the rest of the total pressure
//   h = sigma h_T(z)          mean gap, which the oil fills and the wedge carries
//   g = sigma C(z)^(1/3)      conducting gap, along and across, in xi_R = rho g^3 phi
//   slid = (S/2) sigma phi_s  flow by sliding, S = (u_1 - u_2)/u_m*
// z = H/sigma, all dimensionless, with derivatives by H. Functions of z: roughness/rough_surfaces.hpp. Between smooth
// surfaces P_f = P, h = g = H, slid = 0. On the boundary of the grid asperities carry nothing.
#pragma once

#include <array>
#include <span>

#include "contact/scales.hpp"
#include "grid/halo.hpp"

namespace gearfilm {

struct RoughGap {
  explicit RoughGap(const Grid& grid)
      : film_pressure(grid),
        asperity_slope(grid),
        mean(grid),
        mean_by_gap(grid),
        along(grid),
        along_by_gap(grid),
        across(grid),
        across_by_gap(grid),
        slid(grid),
        slid_by_gap(grid) {}

  Field<double> film_pressure;          ///< P_f
  Field<double> asperity_slope;         ///< dP_a/dH <= 0
  Field<double> mean, mean_by_gap;      ///< h
  Field<double> along, along_by_gap;    ///< g along the entrainment
  Field<double> across, across_by_gap;  ///< g across it
  Field<double> slid, slid_by_gap;
};

/// All of its fields.
inline constexpr std::array<Field<double> RoughGap::*, 10> rough_gap_fields = {
    &RoughGap::film_pressure, &RoughGap::asperity_slope, &RoughGap::mean,   &RoughGap::mean_by_gap,
    &RoughGap::along,         &RoughGap::along_by_gap,   &RoughGap::across, &RoughGap::across_by_gap,
    &RoughGap::slid,          &RoughGap::slid_by_gap};

/// Fills the gap at the own nodes from P and H there. sliding: S of every own row.
void evaluate(const Scales& scales, const Grid& grid, std::span<const double> sliding,
              const Field<double>& total_pressure, const Field<double>& thickness, RoughGap& gap);

/// P_a = P - P_f of the own nodes of a line.
inline double asperity_pressure(const RoughGap& gap, const Field<double>& total_pressure, int i, int j) {
  return total_pressure.row(i)[j] - gap.film_pressure.row(i)[j];
}

void exchange_ghosts(const Halo& halo, RoughGap& gap);

}  // namespace gearfilm
