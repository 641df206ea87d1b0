// The affine map that fits motions and those that follow from them, by least squares, with the errors of
// its multipliers.
#pragma once

#include <complex>
#include <vector>

#include "mesh/motion.hpp"
#include "orbits/monodromy.hpp"

namespace gearfilm {

/// A motion and the one that follows from it, relative to something near both.
struct Return {
  Motion from, to;
};

/// Least squares y = X b with X = (q, v, 1), all rows of the map at once.
class AffineFit {
public:
  explicit AffineFit(const std::vector<Return>& returns);

  Monodromy map() const { return solution_.topRows(solution_.cols()).transpose(); }
  /// Returns without which the map is not known.
  static std::size_t unknowns(const Motion& motion) { return static_cast<std::size_t>(2 * motion.freedoms() + 1); }
  /// The motion that the map leaves as it is; not finite where there is none.
  Motion fixed_point() const;
  /// Standard deviation of an eigenvalue of the map, to first order: d(mu) = w.dM v/(w.v) with its eigenvectors. Zero
  /// where there are no more returns than unknowns.
  double deviation(const std::complex<double>& mu) const;

private:
  double scale_ = 0.0;        ///< size of the motions, which X has in the place of 1, so that its columns are balanced
  Eigen::MatrixXd inverse_;   ///< of X^T X
  Eigen::MatrixXd solution_;  ///< b, a column for each row of the map
  Eigen::VectorXd variance_;  ///< of what the rows of the map leave of y
};

}  // namespace gearfilm
