// The drive train of a case.
#pragma once

#include <optional>

#include "gear/line_of_action.hpp"
#include "input/parameter_values.hpp"
#include "train/train_damping.hpp"

namespace gearfilm {

struct CaseInput;

struct TrainCase {
  Train train;                 ///< with the row of the contact
  double damping_ratio = 0.0;  ///< of every mode
};

/// A key of the drive train that is given; empty where none is.
std::string given_train_key(const ParameterValues& values);

/// Absent where no key of it is given: the gears then turn on rigid supports, and nothing is joined to them. Throws
/// InputError where it does not fit together.
std::optional<TrainCase> read_train(const ParameterValues& values, const LineOfAction& line);

/// Throws InputError where a command moves the pair on rigid supports, and the case has a drive train.
void require_rigid_supports(const CaseInput& problem, const std::string& command);

/// Its modes and damping on the stiffness of the dry mesh; of dry contacts with their damper. Of a case with a train.
DampedTrain damped_train_of(const CaseInput& problem);

/// By how much the static force parts the centres of the gears on their bearings [m].
double centre_distance_growth(const CaseInput& problem);

}  // namespace gearfilm
