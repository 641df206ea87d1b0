// The history of a march in results.h5: one row a step in /history/steps, one row a contact and step in
// /history/contacts; rows with dT = 0 are the states after a contact entered or left, or after a jump
// of the motion in a search. SI beside T, H0, V0.
#pragma once

#include "gearfilm/dynamics/contact_path.hpp"
#include "gearfilm/dynamics/step_record.hpp"
#include "gearfilm/output/results_table.hpp"

namespace gearfilm {

class History {
public:
  /// The dry model has no film columns.
  History(ResultsFile& file, const Scales& scales, const ContactPath& path, bool lubricated);

  void append(const StepRecord& record);
  /// Writes what waits in memory.
  void write();

private:
  Scales scales_;
  const ContactPath& path_;
  bool lubricated_;
  ResultsTable steps_;
  ResultsTable contacts_;
  int step_ = 0;
};

}  // namespace gearfilm
