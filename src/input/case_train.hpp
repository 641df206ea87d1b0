// The drive train of a case.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "gear/line_of_action.hpp"
#include "input/parameter_values.hpp"
#include "mesh/mesh_train.hpp"
#include "train/train_damping.hpp"
#include "train/two_bearings.hpp"

namespace gearfilm {

struct CaseInput;

/// How torques that fluctuate repeat together with the mesh.
struct TorquePattern {
  std::optional<long> periods = 1;  ///< mesh periods; absent: never
  std::string given_by{};           ///< what fluctuates, for messages
  std::optional<double> fixed{};    ///< a frequency that is no order of a shaft [Hz]
};

struct TrainCase {
  Train train;                        ///< with the row of the contact
  Eigen::RowVectorXd back;            ///< the row of the reverse flanks' approach
  Eigen::MatrixXd friction;           ///< FlankRows::friction
  std::vector<NodeTorque> torques{};  ///< in balance with the static force
  TorquePattern pattern{};
  double damping_ratio = 0.0;                                ///< of every mode
  std::array<std::optional<TwoBearings>, 2> two_bearings{};  ///< of gears on bearings at a distance
};

/// Whether a key is one of a drive train.
bool is_train_key(const std::string& key);
/// A key of the drive train that is given; empty where none is.
std::string given_train_key(const ParameterValues& values);

/// Absent where no key of it is given: the gears then turn on rigid supports, and nothing is joined to them. Throws
/// InputError where it does not fit together.
std::optional<TrainCase> read_train(const ParameterValues& values, const LineOfAction& line);

/// Mesh periods after which teeth with errors and fluctuations of the torque repeat together; those of the teeth where
/// the others never do.
long whole_pattern(const CaseInput& problem);

/// Throws InputError where a command moves the pair with its drive train, and cannot: the torque does not
/// determine the tooth force, or it changes while bodies are in balance.
void require_moving_train(const CaseInput& problem, const std::string& command);

/// What the motion of the pair feels of it; null without one, and where the torque does not determine the tooth force.
std::shared_ptr<const MeshTrain> mesh_train_of(const CaseInput& problem);

/// Its modes and damping on the stiffness of the dry mesh; of dry contacts with their damper. Of a case with a train.
DampedTrain damped_train_of(const CaseInput& problem);

/// By how much the static force parts the centres of the gears on their bearings [m].
double centre_distance_growth(const CaseInput& problem);

}  // namespace gearfilm
