#include "dynamics/march_keeper.hpp"

namespace gearfilm {

std::unique_ptr<MarchKeeper> MarchKeeper::within(const std::string&, const Grid&) const { return nullptr; }

std::optional<KeptRun> take_over(MarchKeeper* keeper, double T, const Motion& motion, const StepObserver& observer) {
  if (!keeper) return {};
  std::optional<KeptRun> kept = keeper->begin_run(T, motion);
  if (!kept) return {};
  for (StepRecord& record : kept->records) {
    record.recalled = true;
    observer(record, {});
  }
  return kept;
}

}  // namespace gearfilm
