// The affine map of the plane that fits motions and those that follow from them, by least squares, with the errors of
// its multipliers.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "gearfilm/dynamics/motion.hpp"
#include "gearfilm/orbits/monodromy.hpp"

namespace gearfilm {

/// A motion and the one that follows from it, relative to something near both.
struct Return {
  Motion from, to;
};

/// Least squares y = X b with X = (H_0, V_0, 1), both rows of the map at once.
class AffineFit {
public:
  explicit AffineFit(const std::vector<Return>& returns);

  Monodromy map() const { return {{{solution_[0][0], solution_[0][1]}, {solution_[1][0], solution_[1][1]}}}; }
  /// The motion that the map leaves as it is; not finite where there is none.
  Motion fixed_point() const;
  /// Standard deviation of an eigenvalue of the map, to first order: d(mu) = w.dM v/(w.v) with its eigenvectors. Zero
  /// where there are no more returns than unknowns, three.
  double deviation(const std::complex<double>& mu) const;

private:
  std::array<double, 3> columns(const Return& one) const { return {one.from.H0, one.from.V0, scale_}; }
  /// By cofactors.
  void invert();

  double scale_ = 0.0;  ///< of the motions: the third column's, so that the equations are balanced
  std::array<double, 9> inverse_{};
  std::array<std::array<double, 3>, 2> right_{}, solution_{};
  std::array<double, 2> variance_{};
};

}  // namespace gearfilm
