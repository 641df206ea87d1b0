// The stationary film of one contact: a bare one, or that of a pair at one position on the line of action.
#pragma once

#include <memory>

#include "gearfilm/results.hpp"

namespace gearfilm {

class StationaryFilm {
public:
  /// Solves for the film: on the nodes that the case gives, else as accurately as it asks for (grid.accuracy). Throws
  /// SolveError, and InputError for more processes than rows. Collective.
  StationaryFilm(MPI_Comm comm, const Case& of);

  /// The results of `gearfilm steady`: h_central, h_min, p_max, force, their errors, friction where the case has it,
  /// ...
  const Results& results() const;
  Film film() const;

private:
  struct Solution;
  std::shared_ptr<const Solution> solution_;
};

}  // namespace gearfilm
