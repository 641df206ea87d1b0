// One periodic state of a case, found and described: what `gearfilm periodic` does once and `gearfilm sweep` often.
#pragma once

#include <array>
#include <complex>
#include <optional>

#include "gearfilm/dynamics/march_statistics.hpp"
#include "gearfilm/input/case.hpp"
#include "gearfilm/orbits/free_decay.hpp"
#include "gearfilm/orbits/periodic_orbit.hpp"
#include "gearfilm/orbits/spectrum.hpp"
#include "output/checkpoint.hpp"
#include "output/stop_request.hpp"
#include "output/summary.hpp"

namespace gearfilm {

struct OrbitRun {
  PeriodicOrbit orbit;
  PeriodFigures figures;                     ///< of the periodic period
  std::vector<Motion> states_after_leaving;  ///< one a mesh period of it
  bool contact_lost = false;                 ///< in it
  SignalDeviation transmission_error;        ///< of H_0 over it
  std::optional<FreeDecay> decay;            ///< with the multipliers
  std::vector<double> memory;                ///< MeshMarch::memory() at its end
};

/// Watches a search: every accepted step, and every period marched. Nothing is reported once the orbit is found. The
/// checkpoint keeps all of it, and may know a part.
struct OrbitObservers {
  StepObserver on_step = unseen;
  SearchObserver on_period = [](const SearchPeriod&) {};
  SearchObserver on_coarse_period = on_period;  ///< of a search on a coarser grid, before
  /// Why there is none on it: the search goes on without.
  std::function<void(const std::string&)> on_trouble = [](const std::string&) {};
  Checkpoint& checkpoint;
  const StopRequest& stop;
};

/// Throws SolveError where no orbit is found, and Stopped.
OrbitRun run_orbit(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                   const OrbitGuess& guess, const OrbitObservers& observers);

/// The guess after one period and one Newton step. Throws SolveError and Stopped.
OrbitGuess improve_guess(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                         const OrbitGuess& guess, const OrbitObservers& observers);

/// The return of the pair pushed off an orbit that was found with other tolerances.
FreeDecay decay_from(const Case& problem, const SharedDiscretisation& films, const MeshModel& mesh, const OrbitRun& run,
                     const OrbitObservers& observers);

/// Its figures in SI.
Summary orbit_summary(const MeshModel& mesh, const OrbitRun& run);

/// Multipliers, and the free oscillation they mean, added to a summary.
void add_multipliers(const MeshModel& mesh, const Multipliers& pair, Summary& summary);

}  // namespace gearfilm
