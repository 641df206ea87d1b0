// All functions of the gap of rough surfaces at once, from one table: what films evaluate at every node and iteration.
//
// Cubic Hermite interpolation of ln p_a, h_T/sigma and ln C^(1/3) at z = -6 to 12 in steps of 0.05, within 1e-7 of the
// functions but where C goes on as an exponential (1e-4). Slopes are those of the interpolation. Beyond the table the
// functions themselves serve; from z = 12 on asperities carry nothing.
#pragma once

#include <array>
#include <vector>

#include "roughness/rough_surfaces.hpp"

namespace gearfilm {

class GapTable {
public:
  explicit GapTable(const RoughSurfaces& surfaces);

  struct Values {
    double pressure, pressure_slope;  ///< p_a [Pa], and by z
    GapFunction mean;                 ///< h_T/sigma
    GapFunction along, across;        ///< C^(1/3)
  };
  Values operator()(double z) const;

private:
  static constexpr double first = -6.0, last = 12.0, step = 0.05;
  enum Function { log_pressure, mean_gap, log_along, log_across, functions };
  struct Point {
    std::array<double, functions> value, rise;  ///< rise: slope times step
  };

  Values beyond(double z) const;

  RoughSurfaces surfaces_;
  bool isotropic_;
  std::vector<Point> points_;
};

}  // namespace gearfilm
