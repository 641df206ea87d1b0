// The periodic state of a gear pair on its films, found by shooting.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "gearfilm/simulation.hpp"

namespace gearfilm {

class PeriodicState {
public:
  /// Searches for the state that repeats after periodic.order mesh periods. The same state on coarser grids gives its
  /// errors. The observer sees the steps of all periods that are marched on the case's own grid, the periodic one last;
  /// time begins anew where a search from another start does.
  /// Throws InputError for a case that cannot have a periodic state, and SolveError where none is found. Collective.
  PeriodicState(MPI_Comm comm, const Case& of, const Observer& observer = {});

  /// The results of `gearfilm periodic`: force_ratio_max, h_min, p_max, transmission_error_peak_to_peak, ... and the
  /// error of each as NAME_error.
  const Results& results() const { return results_; }
  /// Floquet multipliers of the motion; none where the case does not ask for them (periodic.multipliers).
  const std::vector<std::complex<double>>& multipliers() const { return multipliers_; }
  /// Whether disturbances of the motion die away; nothing where there are no multipliers.
  std::optional<bool> stable() const;
  /// When the periodic one of the marched periods begins and ends, on the clock of the observer's steps [s].
  double begin() const { return begin_; }
  double end() const { return end_; }

private:
  Results results_;
  std::vector<std::complex<double>> multipliers_;
  double begin_ = 0.0, end_ = 0.0;
};

}  // namespace gearfilm
