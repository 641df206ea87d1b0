#include "train/contact_modes.hpp"

#include <algorithm>

#include "algebra/dense.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

constexpr double told_by_tolerance = 30.0;  // change of s over the tolerance of S from which secants have a slope
constexpr double tighter_than_step = 1e-3;  // tolerance of S in the last change of s

/// T(s) and T'(s), for S and its slope.
struct Pencil {
  explicit Pencil(const DampedTrain& of)
      : M(of.relative.projected(of.train.mass())),
        C(of.relative.projected(of.damping)),
        K(of.relative.projected(of.train.stiffness())),
        contact((of.train.contacts() * of.relative.motions).transpose() * of.train.contacts() * of.relative.motions) {}

  Eigen::MatrixXcd at(std::complex<double> s, std::complex<double> stiffness) const {
    return s * s * M + s * C + K + stiffness * contact;
  }
  Eigen::MatrixXcd derivative(std::complex<double> s, std::complex<double> slope) const {
    return 2.0 * s * M + C + slope * contact;
  }

  Eigen::MatrixXcd M, C, K, contact;
};

}  // namespace

std::complex<double> contact_mode(const DampedTrain& train, const TrainMode& undamped, const DynamicContact& contact,
                                  const ContactModeOptions& options) {
  const Pencil pencil(train);
  const bool felt = undamped.mesh_share > options.unfelt_share;
  const Eigen::VectorXcd start = train.relative.coordinates * undamped.shape;
  const Eigen::RowVectorXcd weight = start.transpose() * pencil.M;
  Eigen::VectorXcd shape = start;
  std::complex<double> s(0.0, undamped.rate), before = s, stiffness_before = 0.0, slope = 0.0;
  double tolerance = options.loosest, tolerance_before = options.loosest;
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    const std::complex<double> stiffness = felt ? contact(s, tolerance) : 0.0;
    if (std::abs(s - before) > told_by_tolerance * tolerance_before * std::abs(s)) {
      slope = (stiffness - stiffness_before) / (s - before);
    }
    const Eigen::VectorXcd next = solved_complex(pencil.at(s, stiffness), pencil.derivative(s, slope) * shape);
    const std::complex<double> step = (weight * shape).value() / (weight * next).value();
    const double change = std::abs(step) / std::abs(s);
    shape = next / next.norm();
    before = s;
    stiffness_before = stiffness;
    s -= step;
    const bool tight = !felt || tolerance <= options.tightest;
    tolerance_before = tolerance;
    tolerance = std::clamp(tighter_than_step * change, options.tightest, tolerance);
    if (!tight || change > options.tolerance) continue;
    if (s.imag() > options.tolerance * std::abs(s)) return s;
    break;
  }
  throw SolveError("no oscillation next to the mode of ", undamped.frequency(), " Hz found");
}

}  // namespace gearfilm
