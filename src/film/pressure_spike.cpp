#include "film/pressure_spike.hpp"

#include <algorithm>
#include <vector>

namespace gearfilm {
namespace {

// Of the first maximum. Less than the first two is what Newton's method leaves.
constexpr double least_fall = 1e-4;
constexpr double least_rise = 1e-3;
constexpr double sharp_fall = 0.1;  // from one node to the next

/// One line, node by node from the inlet on.
class LineWalk {
public:
  void pass(double pressure) {
    if (!fallen_) {
      if (last_ == first_ && pressure < (1.0 - sharp_fall) * first_) spike_ = first_;
      first_ = std::max(first_, pressure);
      fallen_ = pressure < (1.0 - least_fall) * first_;
      valley_ = pressure;
      last_ = pressure;
    } else if (pressure < valley_) {
      valley_ = pressure;
    } else if (pressure > valley_ + least_rise * first_) {
      spike_ = std::max(spike_, pressure);
    }
  }
  double spike() const { return spike_; }

private:
  double first_ = 0.0, last_ = 0.0, valley_ = 0.0, spike_ = 0.0;
  bool fallen_ = false;
};

}  // namespace

double spike_pressure(const Grid& grid, const Field<double>& pressure) {
  std::vector<LineWalk> lines(grid.y_count());
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) lines[j].pass(pressure.row(i)[j]);
  }
  double spike = 0.0;
  for (const LineWalk& line : lines) spike = std::max(spike, line.spike());
  return spike;
}

}  // namespace gearfilm
