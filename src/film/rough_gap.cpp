#include "film/rough_gap.hpp"

#include "parallel/events.hpp"

namespace gearfilm {

void evaluate(const Scales& scales, const Grid& grid, std::span<const double> sliding,
              const Field<double>& total_pressure, const Field<double>& thickness, RoughGap& gap) {
  const ScopedEvent event(Kernel::film_properties);
  const RoughSurfaces& rough = *scales.solids.rough;
  const double sigma = rough.sigma() / scales.thickness, inverse = 1.0 / sigma, unit = 1.0 / scales.pressure;
  for (int i = 0; i < grid.nx(); ++i) {
    const double *P = total_pressure.row(i), *H = thickness.row(i);
    double *P_f = gap.film_pressure.row(i), *slope = gap.asperity_slope.row(i), *mean = gap.mean.row(i),
           *mean_H = gap.mean_by_gap.row(i), *along = gap.along.row(i), *along_H = gap.along_by_gap.row(i),
           *across = gap.across.row(i), *across_H = gap.across_by_gap.row(i), *slid = gap.slid.row(i),
           *slid_H = gap.slid_by_gap.row(i);
    for (int j = 0; j < grid.y_count(); ++j) {
      const GapValues at = rough.at(inverse * H[j]);
      const double carries = grid.is_boundary(i, j) ? 0.0 : unit;
      P_f[j] = P[j] - carries * at.pressure;
      slope[j] = carries * inverse * at.pressure_slope;
      mean[j] = sigma * at.mean.value;
      mean_H[j] = at.mean.slope;
      along[j] = sigma * at.along.value;
      along_H[j] = at.along.slope;
      across[j] = sigma * at.across.value;
      across_H[j] = at.across.slope;
      slid[j] = 0.5 * sliding[j] * sigma * at.shear.value;
      slid_H[j] = 0.5 * sliding[j] * at.shear.slope;
    }
  }
}

void exchange_ghosts(const Halo& halo, RoughGap& gap) {
  halo.exchange(gap.asperity_slope, gap.mean, gap.mean_by_gap, gap.along, gap.along_by_gap, gap.across,
                gap.across_by_gap, gap.slid, gap.slid_by_gap);
}

}  // namespace gearfilm
