// Functions of the gap of rough surfaces, all at once from one table: what films evaluate at every node and iteration.
//
// Cubic Hermite interpolation of ln p_a, h_T/sigma, ln C^(1/3) and phi_s at z = -6 to 12 in steps of 0.05, within 1e-7
// of the functions but where C goes on as an exponential (1e-4), where phi_s begins, from 0 to 0.1, and where its
// branches meet, at 5; from z = 12 on of C^(1/3)/z and phi_s over 12/z = 0 to 1. Slopes are those of the interpolation.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "roughness/rough_flow.hpp"

namespace gearfilm {

/// What surfaces have at one z.
struct GapValues {
  double pressure, pressure_slope;  ///< p_a [Pa], and by z
  GapFunction mean;                 ///< h_T/sigma
  GapFunction along, across;        ///< C^(1/3)
  GapFunction shear;                ///< phi_s
};

class GapTable {
public:
  static constexpr double first = -6.0, last = 12.0;

  /// isotropic: C is the same across as along; has_shear: phi_s is not zero.
  GapTable(const std::function<GapValues(double)>& of, bool isotropic, bool has_shear);

  /// first < z < last.
  GapValues operator()(double z) const;
  /// z >= last, where asperities carry nothing and h_T/sigma = z.
  GapValues far(double z) const;

private:
  static constexpr double step = 0.05;
  static constexpr int far_steps = 240;
  enum Function { log_pressure, mean_gap, log_along, log_across, shear_flow, functions };
  struct Point {
    std::array<double, functions> value, rise;  ///< rise: slope times step
  };

  bool isotropic_, has_shear_;
  std::uint32_t first_far_ = 0;  ///< of the points
  std::vector<Point> points_;
};

}  // namespace gearfilm
