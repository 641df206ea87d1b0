#include "orbits/film_branch.hpp"

#include <algorithm>
#include <limits>
#include <memory>

#include "grid/remap.hpp"
#include "orbits/free_decay.hpp"

namespace gearfilm {
namespace {

// Between two states, from which derivatives are told: above the noise of marches, and of one linear map.
constexpr double shortest_secant = 1e-3, longest_secant = 1.0;

/// Of the forces in a march, over the static one.
struct ForceRange {
  double largest = 0.0;                                  ///< on one contact
  double smallest = std::numeric_limits<double>::max();  ///< of all together

  void add(const StepRecord& record, double static_force) {
    for (const ContactRecord& contact : record.contacts) {
      largest = std::max(largest, contact.quantities["force"] / static_force);
    }
    smallest = std::min(smallest, record.pressure_integral() / static_force);
  }
};

class FilmMap {
public:
  FilmMap(MarchAt march_at, BranchMap dry, FilmBranchOptions options)
      : march_at_(std::move(march_at)), dry_(std::move(dry)), options_(std::move(options)) {}

  MapValue operator()(const BranchState& at, int order) {
    ForceRange forces;
    bool counting = false;
    double static_force = 1.0;
    MeshMarch march = march_at_(at.parameter, order, [&](const StepRecord& record, const std::vector<ActiveContact>&) {
      if (counting) forces.add(record, static_force);
    });
    static_force = march.mesh().scales.static_force;
    const double pattern = march.mesh().pattern * march.mesh().path.mesh_period();
    place(march, at.motion, pattern);
    PeriodicOrbit orbit;
    orbit.start = march.state();
    counting = true;
    MapValue value;
    for (int n = 1; n <= order; ++n) {
      march.run(n * pattern);
      value.states.push_back(march.motion());
    }
    options_.films = march.state();
    value.largest_force = forces.largest;
    value.smallest_force = forces.smallest;
    value.least_approach = forces.smallest - options_.lost;
    set_derivatives(at, order, value);
    orbit.end = *options_.films;
    value.measure = [this, at, order, orbit = std::move(orbit)](MapValue& found) { measure(at, order, orbit, found); };
    return value;
  }

private:
  /// The march begins at the motion, with films that a march has made.
  void place(MeshMarch& march, const Motion& motion, double pattern) {
    const bool kept = options_.films && same_lattice(options_.films->shape, march.discretisation()->grid().shape());
    if (!kept) {
      march.start(motion);
      march.run(pattern);
      options_.films = march.state();
    }
    march.resume(0.0, *options_.films);
    march.displace(motion);
  }

  void set_derivatives(const BranchState& at, int order, MapValue& value) {
    BranchState dry_state = at;
    dry_state.motion.H0() -= options_.film_shift;
    const MapValue dry = dry_(dry_state, order);
    const Eigen::Index size = dry.by_motion.rows();
    BranchVector u(size + 1);
    u << to_vector(at.motion), at.parameter / options_.unit;
    Eigen::MatrixXd whole(size, size + 1);
    whole << dry.by_motion, options_.unit * to_vector(dry.by_parameter);
    if (order != last_order_) correction_ = Eigen::MatrixXd::Zero(size, size + 1);
    whole += correction_;
    if (order == last_order_) update(u, value.image(), whole);
    value.by_motion = whole.leftCols(size);
    value.by_parameter = to_motion(whole.col(size) / options_.unit);
    last_order_ = order;
    last_ = u;
    last_image_ = value.image();
  }

  /// What the pair does that is pushed off the orbit.
  void measure(const BranchState& at, int order, const PeriodicOrbit& orbit, MapValue& value) {
    MeshMarch march = march_at_(at.parameter, order, unseen);
    const Monodromy map = free_decay(march, orbit, {}).map;
    if (map.size() == 0) return;  // the push was gone at once
    correction_.leftCols(map.cols()) += map - value.by_motion;
    value.by_motion = map;
  }

  /// Broyden: the least change by which the derivatives agree with the last two marches.
  void update(const BranchVector& u, const Motion& image, Eigen::MatrixXd& whole) {
    const BranchVector step = u - last_;
    if (step.norm() < shortest_secant || step.norm() > longest_secant) return;
    const Eigen::VectorXd error = to_vector(difference(image, last_image_)) - whole * step;
    const Eigen::MatrixXd least = error * step.transpose() / step.squaredNorm();
    whole += least;
    correction_ += least;
  }

  MarchAt march_at_;
  BranchMap dry_;
  FilmBranchOptions options_;   ///< its films: those that the last march ended with
  Eigen::MatrixXd correction_;  ///< of the dry map's derivatives in u
  int last_order_ = 0;
  BranchVector last_;
  Motion last_image_;
};

}  // namespace

BranchMap film_branch_map(MarchAt march_at, BranchMap dry, const FilmBranchOptions& options) {
  auto map = std::make_shared<FilmMap>(std::move(march_at), std::move(dry), options);
  return [map](const BranchState& at, int order) { return (*map)(at, order); };
}

}  // namespace gearfilm
