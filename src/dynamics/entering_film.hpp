// The stationary films with which contacts enter.
//
// Teeth enter at the same place one after the other, and a pair that nearly repeats lies there as it lay a mesh period
// ago: the film of the last one is then a guess for the next, which Newton's method alone improves, at once or by
// displacements between.
#pragma once

#include <vector>

#include "dynamics/binary_stream.hpp"
#include "solver/stationary.hpp"

namespace gearfilm {

class EnteringFilm {
public:
  /// The film under this load, by a displacement: from the last one where that is near, else from nothing. Throws
  /// SolveError.
  StationaryResult solve(ContactFilm& film, const LoadCondition& load, const SolverOptions& options);

  /// Appends the last film on this process to a list, to be stored.
  void append_to(std::vector<double>& values) const;
  void take_from(ValueReader& values);

private:
  GridShape shape_{};
  FilmSolution last_;  ///< without pressures before the first
};

}  // namespace gearfilm
