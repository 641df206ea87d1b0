// Modes of a drive train on the films of its gears at rest: contact_modes.hpp with the films' dynamic stiffness.
//
//   S(s) = sum_k [(I + K(s) C)^-1 K(s)]_k          (dynamic_stiffness.hpp)
// All front contacts of a pair of spur gears have the same row B, so that one S stands for all of them.
#pragma once

#include <optional>

#include "orbits/film_swing.hpp"
#include "train/contact_modes.hpp"

namespace gearfilm {

/// s of a mode [1/s]; nothing where it is not found.
using RateOnFilms = std::optional<std::complex<double>>;

/// The rate of each mode, in the order of the train's modes; `lost` is told of those that are not found. The state is
/// at rest. Collective.
std::vector<RateOnFilms> train_on_films(const DampedTrain& train, LubricatedPair& pair, Vec state,
                                        const SwingOptions& options,
                                        const std::function<void(const std::string&)>& lost);

/// Rates on the grid of a swing, and on its coarser grid; none of these where that has no mode.
struct RatesOnGrids {
  std::vector<RateOnFilms> fine, coarser{};
};

/// Frequency and damping ratio of each mode, with their errors; nothing where it is not found.
std::vector<std::optional<SwingQuantities>> quantities_of(const DampedTrain& train, const RatesOnGrids& rates,
                                                          const FilmSwing& swing, const Scales& scales);

}  // namespace gearfilm
