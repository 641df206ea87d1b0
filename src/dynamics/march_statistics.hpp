// Gathers the results of a march from its steps: quantities of every mesh period, events, and losses of contact. All
// are dimensionless.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dynamics/period_quantities.hpp"
#include "mesh/speed_course.hpp"

namespace gearfilm {

/// Contact counts as lost where the total force is below this part of the static one F*.
constexpr double lost_force_ratio = 0.02;

struct MeshEvent {
  enum class Kind { entry, exit };
  Kind kind = Kind::entry;
  int contact = 0;
  double T = 0.0;
  Motion motion;
};

/// An interval without force between the gears.
struct ContactLoss {
  double begin = 0.0;
  double end = 0.0;
  double largest_central_film = 0.0;
};

class MarchStatistics {
public:
  MarchStatistics(double mesh_period, double static_force, const SpeedCourse& course = {})
      : mesh_period_(mesh_period), static_force_(static_force), course_(course) {}

  /// given: which quantities there are.
  void add(const StepRecord& record, const AvailableModels& given);

  const std::vector<PeriodQuantities>& periods() const { return periods_; }
  const std::vector<MeshEvent>& events() const { return events_; }
  const std::vector<ContactLoss>& losses() const { return losses_; }
  /// Whether contact was lost at any time in between.
  bool contact_lost(double T_begin, double T_end) const;

private:
  void add_events(const StepRecord& record);
  void add_loss(const StepRecord& record);
  void add_to_period(const StepRecord& record, const AvailableModels& given);
  void add_contact(const StepRecord& record, const ContactRecord& contact, const AvailableModels& given,
                   PeriodQuantities& period);

  /// Mean in time over the present period, by the trapezoidal rule.
  void add_to_mean(std::optional<double>& mean, std::size_t quantity, double value, double dT);

  double mesh_period_;
  double static_force_;
  SpeedCourse course_;
  std::vector<PeriodQuantities> periods_;
  std::vector<MeshEvent> events_;
  std::vector<ContactLoss> losses_;
  std::array<double, period_quantities.size()> last_{};  ///< of means, at the last record
  double elapsed_ = 0.0;                                 ///< of the present period, before the last step
  std::vector<int> present_;                             ///< contacts of the last record
  bool lost_ = false;
  std::optional<int> entered_;   ///< contact whose first step is still to come
  double pitch_distance_ = 0.0;  ///< |xi| of the nearest contact of the present period so far [m]
};

}  // namespace gearfilm
