// Modes of a drive train on the films of its gears at rest: contact_modes.hpp with the films' dynamic stiffness.
//
//   S(s) = sum_k [(I + K(s) C)^-1 K(s)]_k          (dynamic_stiffness.hpp)
// All front contacts of a pair of spur gears have the same row B, so that one S stands for all of them.
#pragma once

#include <optional>

#include "orbits/dynamic_stiffness.hpp"
#include "train/contact_modes.hpp"

namespace gearfilm {

/// s of each mode [1/s], in the order of the train's modes; nothing where a mode is not found, of which `lost` is told.
/// The state is at rest. Collective.
std::vector<std::optional<std::complex<double>>> train_on_films(const DampedTrain& train, LubricatedPair& pair,
                                                                Vec state, const SwingOptions& options,
                                                                const std::function<void(const std::string&)>& lost);

}  // namespace gearfilm
