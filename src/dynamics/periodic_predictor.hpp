// What the first guesses of time steps missed a mesh period ago.
//
// Teeth that mesh one after the other go through nearly the same: where the extrapolated film of one falls short, that
// of the next does so at the same place. The guess of a step is therefore
//
//   g + m,  where |e' - m'|^2 < |e'|^2 / 2,  else g
//
// g: the stepper's own guess; m: what its own guess missed at this step a mesh period ago; e' and m': what it missed at
// the step before this one, and a mesh period before that. That is the state a mesh period ago and the extrapolated
// difference from it, for as long as the past is a guide. Guesses decide how soon a step converges, not to what:
// misses are kept to three digits, and one of 1e-8 of the largest still to a fortieth; on grids of many nodes to 2e-5
// of the largest.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "dynamics/binary_stream.hpp"
#include "dynamics/lubricated_pair.hpp"

namespace gearfilm {

class PeriodicPredictor {
public:
  PeriodicPredictor() = default;
  /// Reads back what append_to() wrote, up to the end of the list.
  explicit PeriodicPredictor(ValueReader values);
  /// Appends all that is remembered on this process to a list, to be stored.
  void append_to(std::vector<double>& values) const;

  /// Corrects the stepper's own guess of the state at T. Collective, as is record().
  void correct(const LubricatedPair& pair, Vec guess, double T);
  /// A state at T was solved for, after one at T0.
  void record(const LubricatedPair& pair, Vec solved, double T0, double T);

private:
  struct PredictorError {
    double recorded_at = 0.0;  ///< mesh periods marched until then
    Motion motion;
    // The pressures of all contacts, as codes of their parts of the largest.
    double largest = 0.0;
    std::size_t count = 0;
    std::vector<std::uint8_t> pressures;  ///< packed
  };

  /// Whether an error was recorded so many mesh periods ago that it is no guide any more: `oldest`, 1.5.
  bool is_old(const PredictorError& error) const;
  /// The error of the guess for as many contacts at this place a mesh period ago; null where there is none.
  const PredictorError* last_time(const MeshModel& mesh, double T, std::size_t pressures) const;

  GridShape shape_{};                     ///< of the grid of all that is remembered
  std::map<int, PredictorError> errors_;  ///< by the place in the mesh period
  double marched_ = 0.0;                  ///< mesh periods
  bool trusted_ = false;
  double guessed_at_ = 0.0;  ///< T of the last guess
  Motion guessed_motion_;
  std::vector<double> guessed_;  ///< pressures of the stepper's own; empty once its state is known
};

}  // namespace gearfilm
