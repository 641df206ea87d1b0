// A sweep: which quantity of a gear pair takes which values, in which directions, on how many groups of processes.
#pragma once

#include <string>
#include <vector>

#include "gearfilm/input/parameter_values.hpp"

namespace gearfilm {

struct SweepOptions {
  std::string parameter;       ///< the key that is varied
  std::string unit;            ///< its unit
  std::vector<double> values;  ///< ascending; empty where the case asks for no sweep
  bool up = true;
  bool down = true;
  int chain_points = 0;  ///< points continued from one another; 0: all of a direction
  int groups = 0;        ///< of processes; 0: as many as chains and processes allow
};

/// Throws InputError for a range or a list that is given by half, twice, or cannot be read.
SweepOptions read_sweep(const ParameterValues& values);

}  // namespace gearfilm
