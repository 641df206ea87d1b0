// The history of a march in results.h5: one row a step in /history/steps, one row a contact and step in
// /history/contacts; rows with dT = 0 are the states after a contact entered or left, or after a jump
// of the motion in a search. A row begins with what tells it from others; the quantities of the tables in dynamics
// follow.
#pragma once

#include "dynamics/step_quantities.hpp"
#include "mesh/mesh_model.hpp"
#include "output/results_table.hpp"

namespace gearfilm {

/// A column that says which step or contact a row is of; in SI as it stands.
struct RowKey {
  std::string_view name;
  Unit unit;
  std::string_view meaning;
};

inline constexpr Unit metres_as_given{"m", units::number.in_si};
inline constexpr Unit rpm_as_given{"rpm", units::number.in_si};

inline constexpr auto step_keys = std::to_array<RowKey>({
    {"step", units::count, "number of the row, from 0"},
    {"T", units::number, "time in units of a/u_m* at the end of the step"},
    {"t", units::seconds, "the same"},
    {"dT", units::number, "length of the step; 0 for a start, an entering, a leaving or a jump"},
    {"distance", metres_as_given, "way along the line of action since the start"},
    {"pinion_speed", rpm_as_given, "rotational speed of the pinion"},
});

inline constexpr auto contact_keys = std::to_array<RowKey>({
    {"step", units::count, "row of `/history/steps`"},
    {"contact", units::count, "number of the contact, 0 for the leading one at the start"},
    {"T", units::number, "time in units of a/u_m* at the end of the step"},
    {"t", units::seconds, "the same"},
    {"xi", metres_as_given, "position on the line of action, from the pitch point"},
});

class History {
public:
  /// The dry model has no film columns. The mesh must outlive the history.
  History(ResultsFile& file, const MeshModel& mesh, bool lubricated);

  void append(const StepRecord& record);
  /// Writes what waits in memory.
  void write();

private:
  const MeshModel& mesh_;
  AvailableModels given_;
  ResultsTable steps_;
  ResultsTable contacts_;
  int step_ = 0;
};

}  // namespace gearfilm
