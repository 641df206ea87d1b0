// The parts of a drive train as they are read, before they are put together.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "input/parameter_values.hpp"
#include "train/train.hpp"
#include "train/two_bearings.hpp"

namespace gearfilm {

enum class TrainSide : std::uint8_t { pinion, wheel };

/// A part of a torque that fluctuates, as it is written.
struct WrittenHarmonic {
  double order = 0.0;  ///< of the shaft of its side, or a frequency [Hz]
  double amplitude = 0.0, degrees = 0.0;
  bool fixed = false;  ///< it is a frequency
};

struct TorquePart {
  std::size_t node = 0;
  double mean = 0.0;  ///< in the sense in which its side turns [N m]
  std::vector<WrittenHarmonic> harmonics{};
  std::string origin{};  ///< what messages begin with
};

struct TrainParts {
  struct ShaftPart {
    std::size_t a = 0, b = 0;
    Shaft shaft;
  };
  struct BearingPart {
    std::size_t node = 0;
    Bearing bearing;
  };
  struct GroundPart {
    std::size_t node = 0;
    double stiffness = 0.0, damping = 0.0;
  };

  std::vector<TrainNode> nodes;  ///< the pinion and the wheel first
  std::vector<TrainSide> sides;  ///< of the nodes
  std::vector<ShaftPart> shafts{};
  std::vector<BearingPart> bearings{};
  std::vector<GroundPart> grounds{};
  std::vector<TorquePart> torques{};
  std::array<std::optional<TwoBearings>, 2> two_bearings{};  ///< of the gears

  static constexpr std::size_t pinion = 0, wheel = 1;
};

/// Adds what the file train.file has, one element a line; # begins a remark:
///   node NAME pinion|wheel inertia [mass]      shaft A B k [c [I]]      bearing NODE kx ky [kxy kyx [cx cy]]
///   ground NODE k [c]                          fixed NODE       torque NODE mean [order amplitude phase]...
/// Throws InputError with the line that is wrong.
void add_train_file(const ParameterValues& values, TrainParts& parts);

/// Adds the bearings that a gear has by its keys. Throws InputError where they do not fit together.
void add_gear_bearings(const ParameterValues& values, std::size_t gear, TrainParts& parts);

/// Whether a stiffness stores energy in every direction.
bool is_positive(const Eigen::Matrix2d& stiffness);

}  // namespace gearfilm
