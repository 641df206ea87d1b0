#include "film/rough_gap.hpp"

namespace gearfilm {

void evaluate(const Scales& scales, const Grid& grid, std::span<const double> sliding,
              const Field<double>& total_pressure, const Field<double>& thickness, RoughGap& gap) {
  const RoughSurfaces& rough = *scales.solids.rough;
  const double sigma = rough.sigma() / scales.thickness, inverse = 1.0 / sigma;
  const bool isotropic = rough.isotropic(), slides = rough.has_shear_flow();
  for (int i = 0; i < grid.nx(); ++i) {
    const double *P = total_pressure.row(i), *H = thickness.row(i);
    for (int j = 0; j < grid.y_count(); ++j) {
      const double z = inverse * H[j];
      AsperityLaw::Value asperities{0.0, 0.0};
      if (!grid.is_boundary(i, j)) asperities = rough.asperities()(z);
      gap.film_pressure.row(i)[j] = P[j] - asperities.pressure / scales.pressure;
      gap.asperity_slope.row(i)[j] = asperities.slope * inverse / scales.pressure;
      const GapFunction mean = rough.mean_gap(z), along = rough.conducting_along(z);
      const GapFunction across = isotropic ? along : rough.conducting_across(z);
      gap.mean.row(i)[j] = sigma * mean.value;
      gap.mean_by_gap.row(i)[j] = mean.slope;
      gap.along.row(i)[j] = sigma * along.value;
      gap.along_by_gap.row(i)[j] = along.slope;
      gap.across.row(i)[j] = sigma * across.value;
      gap.across_by_gap.row(i)[j] = across.slope;
      if (!slides) continue;
      const GapFunction shear = rough.shear_flow(z);
      gap.slid.row(i)[j] = 0.5 * sliding[j] * sigma * shear.value;
      gap.slid_by_gap.row(i)[j] = 0.5 * sliding[j] * shear.slope;
    }
  }
}

void exchange_ghosts(const Halo& halo, RoughGap& gap) {
  halo.exchange(gap.asperity_slope, gap.mean, gap.mean_by_gap, gap.along, gap.along_by_gap, gap.across,
                gap.across_by_gap, gap.slid, gap.slid_by_gap);
}

}  // namespace gearfilm
