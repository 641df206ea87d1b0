// Places of a film side by side, for vector instructions.
#pragma once

#include <array>

#include "lubricant/independent_iterations.hpp"

namespace gearfilm {

inline constexpr int film_lanes = 8;
using FilmLanes = std::array<double, film_lanes>;

template <class Operation>
inline void each_lane(Operation operation) {
  GEARFILM_INDEPENDENT_ITERATIONS
  GEARFILM_NOT_UNROLLED
  for (int l = 0; l < film_lanes; ++l) operation(l);
}

}  // namespace gearfilm
