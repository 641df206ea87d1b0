// Branches of periodic motions in one parameter, by pseudo-arclength: through folds, with every bifurcation located,
// and with the branches of doubled period that are born at flips.
//
// A step goes along the tangent and is corrected on the plane across it. It is halved where the corrector fails or the
// branch turns by more than a given angle, and grows where it hardly turns. At a flip P_k(x) = x with the eigenvector v
// of the multiplier -1 a branch of P_2k(x) = x begins in the direction (v, 0). It is followed that way alone: the other
// way are the same motions, a period later.
#pragma once

#include <vector>

#include "orbits/bifurcation.hpp"

namespace gearfilm {

struct ContinuationOptions {
  double lowest = 0.0, highest = 1.0;  ///< of the parameter: a branch ends there
  CorrectorOptions corrector{};
  double first_step = 0.02;  ///< lengths in (q, v, lambda/unit)
  double smallest_step = 1e-6;
  double largest_step = 0.1;
  double located = 1e-6;   ///< to what length of a step bifurcations are located
  int most_points = 5000;  ///< of a branch
  int largest_order = 1;   ///< to which branches born at flips are followed
};

/// at_flip: it has come to where its motions repeat after half the period.
enum class BranchEnd { at_bound, closed, at_flip, most_points, lost };

struct Branch {
  int number = 1;
  int order = 1;
  int parent = 0;  ///< the branch on which it was born; 0: none
  int points = 0;
  BranchEnd end = BranchEnd::lost;
  BranchState last;
  std::optional<BranchState> born;  ///< the flip on its parent
};

/// A point of a branch, and what happens there.
using BranchObserver = std::function<void(const Branch& branch, PointKind kind, const BranchPoint& point)>;

/// The branch through the guess, which is corrected at its parameter, and those of doubled period born on it.
/// upwards: the parameter grows at first. Throws SolveError where there is no periodic motion next to the guess.
std::vector<Branch> follow_branches(const BranchMap& map, int order, const BranchState& guess, bool upwards,
                                    const ContinuationOptions& options, const BranchObserver& observer);

}  // namespace gearfilm
