// What a march says of its own recurrence: the motion once a mesh period, just after a contact has left.
//
//   the march repeats every k mesh periods where |x_n - x_(n-k)| is small for the last k points x = (q, v)
//   as it settles x_(n+k) = A x_n + b; the largest eigenvalue of A is what a disturbance keeps over k periods
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "dynamics/step_record.hpp"

namespace gearfilm {

struct PoincarePoint {
  double T = 0.0;
  Motion motion;
  // Since the point before.
  double largest_force = 0.0;   ///< on one contact [-]
  double smallest_force = 0.0;  ///< on all together [-]
  double smallest_film = 0.0;   ///< [-]; of a lubricated pair
};

/// Gathers the points of a march from its records.
class PoincareSection {
public:
  void add(const StepRecord& record);
  const std::vector<PoincarePoint>& points() const { return points_; }

private:
  void begin();

  std::vector<PoincarePoint> points_;
  PoincarePoint now_;
  std::vector<int> present_;
  bool begun_ = false;
};

struct Recurrence {
  int period = 0;  ///< mesh periods; 0: it does not repeat within 8, or is on its way to repeat after fewer
  double defect =
      0.0;  ///< largest difference of motion between the last `period` points; of one period where none repeats
};

/// How a march settles.
struct Settling {
  int period = 1;  ///< mesh periods over which
  std::complex<double> multiplier;
  double modulus_error = 0.0;  ///< twice its standard deviation
  Motion limit;                ///< of the last point and those whole periods before it

  /// Beyond doubt.
  bool contracts() const { return std::abs(multiplier) + modulus_error < 1.0; }
};

/// Distance of motions, in (q, v), within which results say that a march repeats.
constexpr double same_point = 1e-3;

/// Absent where there are fewer than two points.
std::optional<Recurrence> recurrence_of(const std::vector<PoincarePoint>& points, double tolerance);
/// By least squares over the points that are near the last one, yet not lost in noise; absent where these are too few.
/// A march that does not repeat is taken over the fewest mesh periods over which it contracts, or over one.
std::optional<Settling> settling_of(const std::vector<PoincarePoint>& points, const Recurrence& recurrence);

}  // namespace gearfilm
