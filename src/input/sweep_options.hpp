// A sweep: which quantity of a gear pair takes which values, in which directions, on how many groups of processes.
#pragma once

#include <string>
#include <vector>

#include "dynamics/step_record.hpp"
#include "input/parameter_values.hpp"

namespace gearfilm {

enum class SweepKind {
  periodic,  ///< the periodic state at every value
  marches,   ///< a march at every value, from where the last one ended
  basins     ///< a march from every start of a grid of motions, at the case's own values
};

struct SweepOptions {
  SweepKind kind = SweepKind::periodic;
  std::string parameter;       ///< the key that is varied
  std::string unit;            ///< its unit
  std::vector<double> values;  ///< ascending; empty where the case asks for no sweep
  bool up = true;
  bool down = true;
  int chain_points = 0;        ///< points continued from one another; 0: all of a direction
  int groups = 0;              ///< of processes; 0: as many as chains and processes allow
  int march_periods = 0;       ///< mesh periods of a march
  int kept_periods = 0;        ///< at its end, of which the motions are kept
  std::vector<Motion> starts;  ///< of basins; then the values count them

  bool marched() const { return kind != SweepKind::periodic; }
};

/// Throws InputError for a range or a list that is given by half, twice, or cannot be read.
SweepOptions read_sweep(const ParameterValues& values);

}  // namespace gearfilm
