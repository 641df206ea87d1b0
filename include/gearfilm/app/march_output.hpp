// What every march in time leaves on disk and on the screen: history, snapshots, statistics, progress.
#pragma once

#include <optional>

#include "gearfilm/dynamics/march_statistics.hpp"
#include "gearfilm/dynamics/spectrum.hpp"
#include "gearfilm/io/case.hpp"
#include "gearfilm/io/history.hpp"
#include "gearfilm/io/progress.hpp"
#include "gearfilm/io/snapshots.hpp"
#include "gearfilm/io/summary.hpp"

namespace gearfilm {

/// What a march is for: itself, with fields written as it goes; or a search, of which only the last period's fields are
/// wanted.
enum class MarchPurpose { march, search };

class MarchOutput {
public:
  /// Creates results.h5 in the case's output folder. expected_periods: the whole of the work, for the time left.
  MarchOutput(MPI_Comm comm, const Case& problem, const Grid& grid, const ContactPath& path, MarchPurpose purpose,
              const std::string& command, double expected_periods);

  void step(const StepRecord& record, const std::vector<LiveContact>& contacts);
  /// As an observer of a march; this must outlive it.
  StepObserver observer();

  /// A period of a search is over: its fields are written where it is the wanted one, else dropped.
  void end_search_period(const SearchPeriod& period);
  /// Adds the table /spectrum over [T_begin, T_end], and returns its peaks for the summary.
  Summary write_spectrum(double T_begin, double T_end, SpectralWindow window);

  const MarchStatistics& statistics() const { return statistics_; }
  ResultsFile& file() { return file_; }

private:
  void report(const StepRecord& record, double period);

  const Case& problem_;
  const ContactPath& path_;
  MarchPurpose purpose_;
  bool lubricated_;
  double expected_periods_;
  ResultsFile file_;
  History history_;
  std::optional<Snapshots> snapshots_;
  MarchStatistics statistics_;
  MotionSignal signal_;
  Progress progress_;
  double next_snapshot_ = 0.0;
};

/// Figures of one mesh period, in SI.
Summary period_summary(const Scales& scales, const PeriodFigures& period);
/// All of a march: its periods, their extremes, events and losses of contact.
Summary march_summary(const Case& problem, const ContactPath& path, const MarchStatistics& statistics);

}  // namespace gearfilm
