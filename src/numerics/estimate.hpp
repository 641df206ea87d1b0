// Error estimate of a quantity from its values on a grid and on a coarser one.
//
// Errors are of second order: with steps r times as long they are r^2 times as large, so that
//   e = (f(h) - f(r h))/(r^2 - 1)
// is the estimate of the error and f(h) + e the extrapolated value. Two kinds of quantities converge more slowly, and
// have bars of their own, with measured factors (docs/notes/2026-11-factors-of-error-bars.md):
// - Smallest films, and pressures beside a spike, converge with orders of 1.3 to 2: 3 e/2.
// - The outlet's spike (Petrusevich) is thinner than the steps of usual grids: its height grows by 3 to 13 % whenever
//   nodes are doubled, for four doublings and more. Its bar is what two doublings add, which is not the limit: that
//   remains unknown. Where the spike is, or within two doublings may become, the largest pressure, that has its bar.
// A spike carries a force that a grid without its top has wrong by a part of the step times its height. The rest of the
// pressures makes up for that: at least that much they are uncertain.
#pragma once

#include <optional>

namespace gearfilm {

/// A quantity with its bar.
struct Estimate {
  double value = 0.0;
  double error = 0.0;                    ///< of the value, absolute
  std::optional<double> extrapolated{};  ///< nothing where no limit is in sight
  double least = 0.0;                    ///< relative errors are of the value, or of this where it is larger

  double relative_error() const;
  /// From the value to the extrapolated one, relative; of those that have one.
  double relative_rest() const;
};

/// The estimate from the values on a grid, and on one whose steps are `ratio` times as long.
Estimate estimate(double fine, double coarse, double ratio = 2.0);

/// The estimate of a smallest film thickness.
Estimate estimate_smallest(double fine, double coarse, double ratio = 2.0);

/// The estimate of a film of a scheme whose errors fall with the third to fourth power of the step, and may change sign
/// with it: a small difference of two grids is no small error, and the bar is a bound, the part 1/ratio^2 of it and at
/// least `least` of the value.
Estimate estimate_fast(double fine, double coarse, double least, double ratio = 2.0);

/// Pressures on one grid, all in one unit.
struct PeakPressures {
  double pressure = 0.0;  ///< the one whose bar is asked for
  double spike = 0.0;     ///< height of the outlet's spike, zero where there is none
};

/// The estimate of the spike's height; nothing where there is none on the finer grid.
std::optional<Estimate> estimate_spike(double fine, double coarse, double ratio = 2.0);

/// The estimate of a pressure beside a spike, as in the centre. `step`: h_x of the finer grid, in units of a.
Estimate estimate_beside_spike(const PeakPressures& fine, const PeakPressures& coarse, double step, double ratio = 2.0);

/// The estimate of the largest pressure, be it the centre's or the spike's.
Estimate estimate_largest(const PeakPressures& fine, const PeakPressures& coarse, double step, double ratio = 2.0);

}  // namespace gearfilm
