// A march kept on disk as it goes, so that a run that was stopped, killed, or failed can go on.
//
//   steps                   every step so far, to the bit: the history in results.h5 is made from these again
//   run003_00017.state      the state after the 17th segment, which belongs to the fourth run (run_store.hpp), with
//                           the snapshots taken since the state before
//   run003_00017.guesses0   what the first process remembers for first guesses; another number of
//                           processes begins without
// After every segment the steps are appended, and the state is written aside and renamed. What was written last reaches
// the disk while the march goes on, and is there before anything more is written: a failure of the machine costs the
// last state at most. Kept are the last two states, those that end a run, and those with snapshots.
#pragma once

#include <deque>

#include "dynamics/run_store.hpp"
#include "output/async_fsync.hpp"
#include "output/film_snapshot.hpp"
#include "output/step_log.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// What an observer has summed up of a march on its way, kept with its states.
class CarriedSums {
public:
  CarriedSums() = default;
  CarriedSums(const CarriedSums&) = delete;
  CarriedSums& operator=(const CarriedSums&) = delete;
  virtual ~CarriedSums() = default;
  /// Alike on all processes. Collective.
  virtual std::vector<double> sums() const = 0;
  /// Takes what sums() gave, of films on this grid. Collective.
  virtual void take(const std::vector<double>& sums, const Grid& grid) = 0;
};

class Checkpoint final : public RunStore {
public:
  enum class Begin { anew, where_it_stopped };

  /// Creates the folder, or takes over what it holds, which must be of the grid or of one that was widened from it.
  /// Begun again, what this program wrote in the folder goes. Throws OutputError, and InputError where the folder holds
  /// anything else. Collective.
  Checkpoint(const Grid& grid, std::filesystem::path folder, Begin begin);

  std::optional<StoredRun> begin_run(double T, const Motion& motion) override;
  void record(const StepRecord& record) override;
  void keep(double T, const PairState& state, std::vector<double> memory) override;

  /// Keeps these with every state, and gives them back what is kept of a run that is taken over. They must outlive the
  /// marches.
  void carry(CarriedSums& sums) { carried_ = &sums; }
  /// Fields that are to be kept with the next state.
  void attach(const FilmSnapshot& snapshot);
  /// The fields that were kept of the run now taken over, one after the other.
  std::optional<FilmSnapshot> recall_snapshot();
  /// The same of those for stresses, of the step at T; nothing where it has none.
  std::optional<FilmSnapshot> recall_sections(double T);
  /// The snapshots of this run are not wanted.
  void drop_snapshots();

  /// A store in a folder within, begun as this one was.
  std::unique_ptr<RunStore> within(const std::string& name, const Grid& grid) const override {
    return std::make_unique<Checkpoint>(grid, folder_ / name, begin_);
  }

  /// All that this program wrote in the folder goes, and the folder with it where nothing is left.
  void remove();

  /// T of the last state that was found; 0 without one.
  double kept_until() const { return kept_.empty() ? 0.0 : kept_.back().T; }
  /// False while runs are taken over that were completed before.
  bool caught_up() const { return kept_.empty() || run_ >= kept_.back().run; }
  bool is_new(const StepRecord& record) const override { return !record.replayed && caught_up(); }

private:
  struct KeptState {
    int run = 0;
    int number = 0;
    double T = 0.0;
    StepLogMark steps;  ///< behind its last step
    bool with_snapshots = false;
  };

  std::filesystem::path file(const KeptState& state) const;
  std::filesystem::path own_file(const KeptState& state) const;
  void find_states();
  bool complete(KeptState& state, const StepLogMark& steps_before);
  void remove_file(const KeptState& state) const;
  void forget_from(std::size_t first);
  void remove_superfluous();

  Grid grid_;
  std::filesystem::path folder_;
  Begin begin_;
  StepLog log_;
  AsyncFsync flush_;
  std::vector<KeptState> kept_;
  std::vector<double> memory_;  ///< of the last state that was found
  int run_ = -1;
  Summary run_begin_;                ///< T and the motion
  std::vector<StepRecord> waiting_;  ///< since the last state
  std::vector<FilmSnapshot> attached_;
  std::deque<FilmSnapshot> replayed_, replayed_sections_;
  CarriedSums* carried_ = nullptr;
};

}  // namespace gearfilm
