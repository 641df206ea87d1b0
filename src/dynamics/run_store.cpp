#include "dynamics/run_store.hpp"

namespace gearfilm {

std::unique_ptr<RunStore> RunStore::within(const std::string&, const Grid&) const { return nullptr; }

std::optional<StoredRun> resume_from(RunStore* store, double T, const Motion& motion, const StepObserver& observer) {
  if (!store) return {};
  std::optional<StoredRun> kept = store->begin_run(T, motion);
  if (!kept) return {};
  for (StepRecord& record : kept->records) {
    record.replayed = true;
    observer(record, {});
  }
  return kept;
}

}  // namespace gearfilm
