// Backward differences of order 1 to 3 at steps of any lengths, of a transient variable C(state):
//
//   dC/dT(T) = s C + c ,    s C + c the slope at T of the polynomial through C at T and at the last one to three times.
//
// Beside them what other polynomials through the last states say: the next state, and the error of a step as the
// difference that one state more makes (as PETSc's TSBDF has it). Three states are known at most. Weights of slopes:
// slope_weights.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <functional>
#include <vector>

#include "parallel/petsc.hpp"

namespace gearfilm {

class BackwardDifferences {
public:
  /// create: makes a vector for a state or its C.
  explicit BackwardDifferences(const std::function<OwnedVec()>& create);

  /// The state that is sought, or has been found and is not yet known.
  Vec sought() const { return sought_; }
  /// A known one, 0 the latest.
  Vec state(std::size_t n) const { return states_[n]; }
  double time(std::size_t n) const { return times_[n]; }
  int known() const { return known_; }

  /// All but so many of the latest.
  void forget(int but = 0) { known_ = std::min(known_, but); }
  /// What was sought is the state at T, the latest or, with behind, one that comes behind it in the list. transient
  /// gives C(state).
  void keep(double T, bool behind, const std::function<void(Vec state, Vec values)>& transient);
  /// Makes s and c for a stage at T.
  void differentiate(double T, int order);
  double shift() const { return shift_; }
  int order() const { return order_; }
  /// Whether so many known states and one at T follow one another at steps of nearly one length.
  bool evenly_spaced(double T, int states) const;
  /// Weights of the slope at the stage of the polynomial of this order: of the stage, and of the known states.
  std::vector<double> weights(int order) const;
  /// What differences of this order make of d/dT at exp(i w T), w [1/T].
  std::complex<double> of_oscillation(double w, int order) const;
  /// Makes s C + c of C.
  void make_rate(Vec values) const;
  /// Seeks from the polynomial at T through as many states as are known, at most. Returns their weights, latest first.
  std::vector<double> extrapolate(double T, int states);
  /// Error of what was found at T with differences of this order, root mean square of its parts over `allowed`.
  double error(double T, int order, Vec allowed);

private:
  /// T and so many of the latest known times.
  std::vector<double> times_at(double T, int known) const;

  OwnedVec sought_;
  std::array<OwnedVec, 3> states_;
  std::array<OwnedVec, 3> transients_;  ///< C of each
  std::array<double, 3> times_{};
  int known_ = 0;
  double stage_ = 0.0;  ///< its T
  int order_ = 1;
  double shift_ = 0.0;
  OwnedVec constant_;  ///< c; of no use once the state is found
};

}  // namespace gearfilm
