// Torques of a drive train: where they act, how they fluctuate, and whether they balance.
#pragma once

#include "input/case_train.hpp"
#include "input/train_parts.hpp"

namespace gearfilm {

/// Reads "order amplitude phase" or "300Hz amplitude phase"; nothing where they are no such numbers.
std::optional<WrittenHarmonic> read_harmonic(const std::string& words);

/// Adds the torques that keys give, and on a side without any the one that balances the static force: of the motor or
/// the load, or without these of the gear. Throws InputError where those of a side that turns freely do not balance.
void complete_torques(const ParameterValues& values, const LineOfAction& line, TrainParts& parts);

/// In a train that is put together. Throws InputError, also where they swing the whole by more than the teeth let pass.
void set_torques(const ParameterValues& values, const LineOfAction& line, const TrainParts& parts, TrainCase& train);

}  // namespace gearfilm
