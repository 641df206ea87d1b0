// Stored runs, by which a march that was stopped with its program goes on without computing its steps again.
//
// A march is a series of runs; between two runs its state may be set again (a jump of the motion, another period of a
// search). A run is a series of segments, between which contacts enter or leave, or the grid is widened, and the time
// scheme starts afresh: the points at which a march can be taken up with not a bit changed. A program that is started
// again asks for the same runs in the same order. What is kept of a run is taken over; the rest is computed.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/pair_state.hpp"

namespace gearfilm {

/// What is kept of a run: its steps up to the end of a segment, and the state there.
struct StoredRun {
  std::vector<StepRecord> records;
  double T = 0.0;
  PairState state;
  std::vector<double> memory;  ///< what the march remembers on this process (MeshMarch::memory)
};

class RunStore {
public:
  virtual ~RunStore() = default;
  /// A run begins with this motion at T. Collective, as are the others.
  virtual std::optional<StoredRun> begin_run(double T, const Motion& motion) = 0;
  /// A step of the run, or its state after an entering or leaving.
  virtual void record(const StepRecord& record) = 0;
  /// Stores the state at the end of a segment, T; contacts that enter or leave then have not done so yet. memory: what
  /// the march remembers on this process.
  virtual void keep(double T, const PairState& state, std::vector<double> memory) = 0;
  /// A step beyond where the program before came to rest: neither taken over nor done again on the way there.
  virtual bool is_new(const StepRecord& record) const { return !record.replayed; }
  /// Keeps another march, which the run makes on the way on a grid of its own, under this name; null where none is
  /// kept.
  virtual std::unique_ptr<RunStore> within(const std::string& name, const Grid& grid) const;
};

/// RunStore::is_new and within of a store that may be absent: null stands for none.
inline bool is_new(const RunStore* store, const StepRecord& record) {
  return store ? store->is_new(record) : !record.replayed;
}
inline std::unique_ptr<RunStore> store_within(const RunStore* store, const std::string& name, const Grid& grid) {
  return store ? store->within(name, grid) : nullptr;
}

/// Begins a run: shows what is kept of it to the observer, and returns it. Nothing without a store.
std::optional<StoredRun> resume_from(RunStore* store, double T, const Motion& motion, const StepObserver& observer);

}  // namespace gearfilm
