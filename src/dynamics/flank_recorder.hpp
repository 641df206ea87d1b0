// The stresses that contacts leave in both flanks on their way over the path of contact.
//
// Of every contact those sections are kept that its stress recorder has computed (stress_recorder.hpp), at the depths
// of this process. A passage is whole where the contact was followed from its entry to its exit. In a periodic motion
// contacts whose numbers differ by its mesh periods are one tooth's, and a period has a passage of each.
#pragma once

#include <map>

#include "dynamics/step_record.hpp"
#include "fatigue/flank_history.hpp"

namespace gearfilm {

/// What the passage of a contact leaves: in each row of the stress model a history of the pinion's flank and one of the
/// wheel's.
using Passage = std::vector<std::array<FlankHistory, body_count>>;

class FlankRecorder {
public:
  /// keep_all: passages that are over, and not only the last whole one. Of a pair with stresses below all rows only
  /// what the points of its flanks need is kept.
  FlankRecorder(const MeshModel& mesh, bool keep_all);

  /// A step of a march, with its films.
  void observe(const StepRecord& record, const std::vector<ActiveContact>& contacts);
  /// Sections of a contact that were computed elsewhere.
  void add(int number, const SectionRecords& sections);
  /// Contacts that are there now: the others are over.
  void end_others(const std::vector<ContactRecord>& present);

  /// The last contact that was followed from its entry to its exit; null where there is none.
  const Passage* last_whole() const { return last_whole_ ? &*last_whole_ : nullptr; }
  /// One a tooth of a motion that repeats after so many mesh periods.
  std::vector<Passage> of_period(int mesh_periods) const;

private:
  /// The histories in a row of a passage, which has those of all rows before it.
  std::array<FlankHistory, body_count>& row_of(Passage& passage, std::size_t row) const;
  bool is_whole(const Passage& passage) const;

  LineOfAction line_;
  bool keep_all_;
  std::array<FlankPath, body_count> paths_;
  std::array<std::vector<double>, body_count> points_{};  ///< of the flanks; none where whole sections are kept
  std::map<int, Passage> passages_;
  std::optional<Passage> last_whole_;
};

}  // namespace gearfilm
