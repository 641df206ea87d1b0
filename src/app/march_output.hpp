// What every march in time leaves on disk and on the screen: history, snapshots, statistics, progress.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "dynamics/contact_maps.hpp"
#include "dynamics/march_statistics.hpp"
#include "input/case.hpp"
#include "orbits/periodic_orbit.hpp"
#include "orbits/poincare.hpp"
#include "orbits/spectrum.hpp"
#include "output/history.hpp"
#include "output/progress.hpp"
#include "output/resumable_run.hpp"
#include "output/snapshots.hpp"
#include "output/summary.hpp"
#include "results/flank_result.hpp"
#include "results/rating_result.hpp"
#include "results/train_motion.hpp"

namespace gearfilm {

/// What a march is for: itself, with fields written as it goes; or a search, of which only the last period's fields are
/// wanted.
enum class MarchPurpose { march, search };

/// Maps of the flanks' surfaces that go on with the march.
class CarriedMaps final : public CarriedSums {
public:
  template <class... Arguments>
  explicit CarriedMaps(Arguments&&... arguments) : maps(std::forward<Arguments>(arguments)...) {}

  std::vector<double> sums() const override { return maps.values(); }
  void take(const std::vector<double>& sums, const Grid& grid) override { maps.take(sums, grid); }

  ContactMaps maps;
};

class MarchOutput {
public:
  /// Creates results.h5 in the run's folder; where a run goes on, it takes the place of the earlier one as soon as it
  /// holds the same. The mesh must outlive the output. expected_periods: the whole of the work, for the time left.
  MarchOutput(ResumableRun& run, const CaseInput& problem, const Grid& grid, const MeshModel& mesh,
              MarchPurpose purpose, double expected_periods);

  void step(const StepRecord& record, const std::vector<ActiveContact>& contacts);

  /// A period of a search is over: its fields are written where it is the wanted one, else dropped.
  void end_search_period(const SearchPeriod& period);
  /// A line on the screen.
  void note(const std::string& text) { progress_.note(text); }
  /// Adds the tables /spectrum, of a drive train /orders, over [T_begin, T_end]; returns the peaks for the summary.
  Summary write_spectrum(double T_begin, double T_end, SpectralWindow window);

  /// Least safeties over [T_begin, T_end], of a pair that is rated.
  Summary safeties(double T_begin, double T_end) const { return ratings_.safeties(T_begin, T_end); }

  /// Adds /flank/pinion and /flank/wheel: what films did to the surfaces, of a search in the period that it found, and
  /// fatigue where it is judged.
  void write_flanks(const std::optional<FlankResults>& fatigue);

  /// Adds what a drive train does over [T_begin, T_end] to the summary.
  void add_train_motion(double T_begin, double T_end, Summary& summary) const;

  /// Writes and closes results.h5.
  void finish();

  /// Adds the table /history/poincare, and says in the summary how the march repeats and settles.
  void describe_recurrence(Summary& summary);

  /// Time T at the end of the last step.
  double last_time() const { return last_time_; }
  const MarchStatistics& statistics() const { return statistics_; }
  ResultsFile& file() { return file_; }

private:
  void take_snapshot(const StepRecord& record, const std::vector<ActiveContact>& contacts);
  void write_history();
  void publish();
  void report(const StepRecord& record, double period);

  Checkpoint& checkpoint_;
  const CaseInput& problem_;
  const MeshModel& mesh_;
  MarchPurpose purpose_;
  bool lubricated_;
  double expected_periods_;
  ResultsFile file_;
  std::optional<History> history_;
  std::optional<TrainHistory> train_;
  std::optional<Snapshots> snapshots_;
  std::vector<FilmSnapshot> held_;  ///< of a search's present period: only at its end is known whether they are wanted
  MarchStatistics statistics_;
  MotionSignal signal_;
  PoincareSection section_;
  RatingHistory ratings_;
  std::unique_ptr<CarriedMaps> maps_;         ///< null in the dry model
  std::optional<ContactMapPair> found_maps_;  ///< of the period that a search found
  Progress progress_;
  double next_snapshot_ = 0.0;
  double last_time_ = 0.0;
};

/// How far a period of a search was from repeating, in a line.
std::string text_of(const SearchPeriod& period);
}  // namespace gearfilm
