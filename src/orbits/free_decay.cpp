#include "gearfilm/orbits/free_decay.hpp"

#include <algorithm>
#include <cmath>

namespace gearfilm {
namespace {

constexpr double near_orbit = 0.2;      // of a push, from where it began
constexpr double gone = 0.02;           // of a push: what is left is noise
constexpr double far = 4e-2;            // beyond which the map bends
constexpr double smallest_push = 1e-4;  // noise is a hundredth of it

/// One mesh period, relative to the orbit.
struct Return {
  Motion from, to;
};

/// Least squares y = X b with X = (H_0, V_0, 1), both rows of the map at once.
class AffineFit {
public:
  explicit AffineFit(const std::vector<Return>& returns) {
    for (const Return& one : returns) scale_ = std::max(scale_, length(one.from));
    for (const Return& one : returns) {
      const std::array<double, 3> x = columns(one);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) inverse_[3 * i + j] += x[i] * x[j];
        right_[0][i] += x[i] * one.to.H0;
        right_[1][i] += x[i] * one.to.V0;
      }
    }
    invert();
    for (int row = 0; row < 2; ++row) {
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) solution_[row][i] += inverse_[3 * i + j] * right_[row][j];
      }
    }
    const double spare = static_cast<double>(returns.size()) - 3.0;
    if (spare <= 0.0) return;
    for (const Return& one : returns) {
      const std::array<double, 3> x = columns(one);
      for (int row = 0; row < 2; ++row) {
        double rest = row == 0 ? one.to.H0 : one.to.V0;
        for (int i = 0; i < 3; ++i) rest -= x[i] * solution_[row][i];
        variance_[row] += rest * rest / spare;
      }
    }
  }

  Monodromy map() const { return {{{solution_[0][0], solution_[0][1]}, {solution_[1][0], solution_[1][1]}}}; }

  /// Standard deviation of an eigenvalue of the map, to first order: d(mu) = w.dM v/(w.v) with its eigenvectors.
  double deviation(const std::complex<double>& mu) const {
    using Vector = std::array<std::complex<double>, 2>;
    const Monodromy m = map();
    const auto null_vector = [&](double a, double b, double c, double d) {
      const Vector first = {b, mu - a}, second = {mu - d, c};
      const auto size = [](const Vector& of) { return std::norm(of[0]) + std::norm(of[1]); };
      return size(first) > size(second) ? first : second;
    };
    const Vector v = null_vector(m[0][0], m[0][1], m[1][0], m[1][1]);
    const Vector w = null_vector(m[0][0], m[1][0], m[0][1], m[1][1]);
    double spread = 0.0;
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) spread += inverse_[3 * i + j] * std::real(std::conj(v[i]) * v[j]);
    }
    const double rows = std::norm(w[0]) * variance_[0] + std::norm(w[1]) * variance_[1];
    return std::sqrt(rows * spread / std::norm(w[0] * v[0] + w[1] * v[1]));
  }

private:
  std::array<double, 3> columns(const Return& one) const { return {one.from.H0, one.from.V0, scale_}; }

  /// By cofactors.
  void invert() {
    const std::array<double, 9> a = inverse_;
    const auto cofactor = [&](int i, int j) {
      const int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
      return a[3 * k + m] * a[3 * l + n] - a[3 * k + n] * a[3 * l + m];
    };
    const double determinant = a[0] * cofactor(0, 0) + a[1] * cofactor(0, 1) + a[2] * cofactor(0, 2);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) inverse_[3 * i + j] = cofactor(j, i) / determinant;
    }
  }

  double scale_ = 0.0;  ///< of the motions: the third column's, so that the equations are balanced
  std::array<double, 9> inverse_{};
  std::array<std::array<double, 3>, 2> right_{}, solution_{};
  std::array<double, 2> variance_{};
};

/// The pair has come back, to where it stays: near the orbit, which repeats within a tolerance only.
bool forgotten(const std::vector<Motion>& motions, const Motion& orbit) {
  const double push = length(difference(motions[0], orbit));
  const double last = length(difference(motions.back(), motions[motions.size() - 2]));
  return last < gone * push && length(difference(motions.back(), orbit)) < near_orbit * push;
}

/// The motion after 0, 1, 2, ... periods, until the push is gone, or has grown too far.
std::vector<Motion> returns_of(MeshMarch& march, const PeriodicOrbit& orbit, double push, int periods) {
  const MeshModel& mesh = march.mesh();
  const Motion& begin = orbit.start.motion;
  march.resume(mesh.next_period(march.T()), orbit.start);
  march.displace({begin.H0 + push, begin.V0});
  std::vector<Motion> motions = {march.motion()};
  for (int n = 1; n <= periods; ++n) {
    march.run(march.T() + mesh.period());
    motions.push_back(march.motion());
    if (n >= 2 && (forgotten(motions, orbit.end.motion) || length(difference(motions.back(), begin)) > far)) break;
  }
  return motions;
}

}  // namespace

FreeDecay fit_decay(const std::vector<Motion>& motions, const Motion& begin, const Motion& end) {
  std::vector<Return> returns = {{{}, difference(end, begin)}};
  // The first period's films have not followed the push: it counts only where there is nothing better.
  for (std::size_t n = motions.size() > 3 ? 1 : 0; n + 1 < motions.size(); ++n) {
    returns.push_back({difference(motions[n], begin), difference(motions[n + 1], begin)});
  }
  const AffineFit fit(returns);
  FreeDecay decay{fit.map(), multipliers(fit.map()), 0.0};
  const auto& mu = decay.multipliers;
  const std::complex<double> larger = std::abs(mu[0]) >= std::abs(mu[1]) ? mu[0] : mu[1];
  decay.modulus_error = returns.size() > 3 ? 2.0 * fit.deviation(larger) : std::abs(larger);
  return decay;
}

FreeDecay free_decay(MeshMarch& march, const PeriodicOrbit& orbit, const DecayOptions& options) {
  const Motion& begin = orbit.start.motion;
  std::vector<Motion> motions;
  bool near = false;
  for (double push = options.push; push >= smallest_push && !near; push *= 0.1) {
    motions = returns_of(march, orbit, push, options.periods);
    near = length(difference(motions.back(), begin)) <= far;
  }
  if (forgotten(motions, orbit.end.motion)) {
    // Nothing is left to be fitted; how little, the first two returns say.
    const double kept = length(difference(motions[2], motions[1])) / length(difference(motions[1], motions[0]));
    return {{}, {kept, 0.0}, kept};
  }
  return fit_decay(motions, begin, orbit.end.motion);
}

}  // namespace gearfilm
