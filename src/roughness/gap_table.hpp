// Functions of the gap of rough surfaces, all at once from one table: what films evaluate at every node and iteration.
//
// Cubic Hermite interpolation of ln p_a, h_T/sigma and ln C^(1/3) at z = -6 to 12 in steps of 0.05, within 1e-7 of the
// functions but where C goes on as an exponential (1e-4). Slopes are those of the interpolation.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "roughness/rough_flow.hpp"

namespace gearfilm {

/// What surfaces have at one z.
struct GapValues {
  double pressure, pressure_slope;  ///< p_a [Pa], and by z
  GapFunction mean;                 ///< h_T/sigma
  GapFunction along, across;        ///< C^(1/3)
};

class GapTable {
public:
  static constexpr double first = -6.0, last = 12.0;

  /// isotropic: C is the same across as along.
  GapTable(const std::function<GapValues(double)>& of, bool isotropic);

  /// first < z < last.
  GapValues operator()(double z) const;

private:
  static constexpr double step = 0.05;
  enum Function { log_pressure, mean_gap, log_along, log_across, functions };
  struct Point {
    std::array<double, functions> value, rise;  ///< rise: slope times step
  };

  bool isotropic_;
  std::vector<Point> points_;
};

}  // namespace gearfilm
