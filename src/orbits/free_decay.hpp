// How a pushed pair returns to its periodic orbit: the map of the motion over one mesh period, its multipliers, and how
// well they are known.
//
// The pair is pushed off the orbit and marched; q and v are taken once a mesh period. From the first return on the
// films have followed the motion, and each motion follows from the one before by an affine map, of which the orbit is
// the fixed point: least squares over all returns give its numbers, and what is left over gives their errors. Where
// contact is lost that is also what bends of the map contribute. Where the multipliers are not known well by that, and
// less well than half of what the grid has wrong of them, the pair is pushed the other way too: a kink of the map,
// whose sides differ, then shows in the error. With n degrees of freedom as many returns would be needed as 2 n and
// more, of ever smaller motions. There each q and v is pushed by itself for one period, and the pair that then has most
// of the largest multiplier's mode goes on for another, now with films that have followed: what is new to the map in
// that gives the error, and corrects the map.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "orbits/periodic_orbit.hpp"

namespace gearfilm {

struct DecayOptions {
  double lead = 0.0;   ///< PeriodicOptions::lead with which the orbit was found
  int periods = 4;     ///< marched at most; at least 3
  double push = 5e-3;  ///< of the first q [-]: well above the noise of a march, within its linear range
  /// FreeDecay::grid_error of multipliers that are found.
  std::function<double(const Multipliers&)> grid_error = [](const Multipliers&) { return 0.0; };
};

struct FreeDecay {
  Monodromy map;  ///< empty where the push was gone at once
  Multipliers multipliers;
  /// What the fit leaves unknown of the modulus of the larger multiplier [-]: twice its standard deviation; the modulus
  /// itself, where the push was gone before there was more to fit than unknowns.
  double fit_error = 0.0;
  double grid_error = 0.0;              ///< what grid and steps of the march have wrong of that modulus [-]
  std::optional<Monodromy> lead_map{};  ///< of the motion over the lead before the end of a period, where there is one

  /// The error of the modulus of the larger Floquet multiplier [-], from the fit and from the grid together: the root
  /// of the sum of their squares.
  double modulus_error() const { return std::hypot(fit_error, grid_error); }
};

/// The motion of a pushed pair after 0, 1, 2, ... mesh periods, at least three.
using Returns = std::vector<Motion>;

/// After every push that there was; begin and end: of the orbit's period, nearly the same.
FreeDecay fit_decay(const std::vector<Returns>& pushes, const Motion& begin, const Motion& end);

/// The march goes on from the orbit's start. Throws SolveError where it cannot be marched.
FreeDecay free_decay(MeshMarch& march, const PeriodicOrbit& orbit, const DecayOptions& options);

}  // namespace gearfilm
