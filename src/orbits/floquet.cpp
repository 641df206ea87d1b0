#include "orbits/floquet.hpp"

#include <slepceps.h>

#include <algorithm>
#include <cmath>

#include "gearfilm/error.hpp"
#include "numerics/tuned.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

const Tuned<double> smallest_disturbance("floquet_smallest_disturbance", 5e-3,
                                         "smallest disturbance that has a direction above the noise of a march");
const Tuned<double> largest_disturbance("floquet_largest_disturbance", 5e-2,
                                        "largest disturbance that the linearised map describes");

/// The linearised map. Vectors hold the compared fields of all contacts, divided by sqrt(their number) so that they
/// weigh as a root mean square, and on the first process q and v.
class PeriodMap {
public:
  PeriodMap(MeshMarch& march, const PeriodicOrbit& orbit, double size_of_difference)
      : march_(march),
        mesh_(march.mesh()),
        shape_(march.discretisation()->grid().shape()),
        start_(remapped(orbit.start, march.comm(), shape_)),
        end_(remapped(orbit.end, march.comm(), shape_)),
        difference_(size_of_difference),
        rank_(rank_in(march.comm())) {
    for (const ContactFields& fields : start_.films) {
      for (const auto& [name, values] : fields) {
        if (field_named(name).compared) values_ += static_cast<PetscInt>(values.size());
      }
    }
    PetscInt all = values_;
    MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPIU_INT, MPI_SUM, march.comm());
    weight_ = 1.0 / std::sqrt(static_cast<double>(all));
  }

  PetscInt local_size() const { return values_ + (rank_ == 0 ? motion_size() : 0); }
  /// 2 n.
  PetscInt motion_size() const { return static_cast<PetscInt>(2 * start_.motion.freedoms()); }
  MPI_Comm comm() const { return march_.comm(); }

  /// What distinguishes a state from the orbit's end.
  void disturbance_of(const PairState& beside, Vec vec) const { difference_of(beside, end_, vec); }
  /// Makes `vec` the difference from the orbit's end of the state that a period ends with which began with the first
  /// displacement q greater by difference_ [-].
  void displacement(Vec vec) {
    march_.resume(mesh_.next_period(march_.T()), start_);
    Motion displaced = start_.motion;
    displaced.q[0] += difference_;
    march_.displace(displaced);
    difference_of(map(march_.state()), end_, vec);
  }

  void multiply(Vec disturbance, Vec mapped) {
    PetscReal size = 0.0;
    petsc_check(VecNorm(disturbance, NORM_2, &size));
    const double step = difference_ / size;
    difference_of(map(disturbed(disturbance, step)), end_, mapped);
    petsc_check(VecScale(mapped, 1.0 / step));
  }

private:
  PairState map(const PairState& from) {
    march_.resume(mesh_.next_period(march_.T()), from);
    march_.run(march_.T() + mesh_.period());
    return march_.state();
  }

  PairState disturbed(Vec disturbance, double step) const {
    const VecReading values(disturbance);
    PairState state = start_;
    std::size_t next = 0;
    for (ContactFields& fields : state.films) {
      for (auto& [name, field] : fields) {
        const ContactField kind = field_named(name);
        if (!kind.compared) continue;
        for (double& value : field) value = std::max(kind.smallest, value + step / weight_ * values[next++]);
      }
    }
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(motion_size());
    if (rank_ == 0) std::copy_n(&values.values()[next], motion.size(), motion.data());
    MPI_Bcast(motion.data(), motion_size(), MPI_DOUBLE, 0, comm());
    state.motion = to_motion(to_vector(state.motion) + step * motion);
    return state;
  }

  void difference_of(const PairState& state, const PairState& b, Vec vec) const {
    const PairState a = remapped(state, comm(), shape_);
    const VecWriting values(vec);
    std::size_t next = 0;
    for (std::size_t k = 0; k < a.films.size(); ++k) {
      for (const auto& [name, first] : a.films[k]) {
        if (!field_named(name).compared) continue;
        const std::vector<double>& second = b.films[k].at(name);
        for (std::size_t n = 0; n < first.size(); ++n) values[next++] = weight_ * (first[n] - second[n]);
      }
    }
    if (rank_ != 0) return;
    for (const double change : to_vector(difference(a.motion, b.motion))) values[next++] = change;
  }

  MeshMarch& march_;
  const MeshModel& mesh_;
  GridShape shape_;  ///< of all states that are compared
  PairState start_, end_;
  double difference_;
  double weight_ = 1.0;
  PetscInt values_ = 0;  ///< of this process
  int rank_ = 0;
};

}  // namespace

FloquetMultipliers floquet_multipliers(MeshMarch& march, const PeriodicOrbit& orbit, const FloquetOptions& options) {
  PeriodMap map(march, orbit, options.difference);
  const OwnedMat operation = shell_matrix<&PeriodMap::multiply>(map);
  OwnedVec first;
  petsc_check(MatCreateVecs(operation, first.put(), nullptr));
  PetscReal size = 0.0;
  if (orbit.beside) {
    map.disturbance_of(*orbit.beside, first);
    petsc_check(VecNorm(first, NORM_2, &size));
  }
  if (size < smallest_disturbance || size > largest_disturbance) map.displacement(first);
  PetscHandle<EPS, EPSDestroy> eps;
  petsc_check(EPSCreate(march.comm(), eps.put()));
  petsc_check(EPSSetOptionsPrefix(eps, "floquet_"));
  petsc_check(EPSSetOperators(eps, operation, nullptr));
  petsc_check(EPSSetProblemType(eps, EPS_NHEP));
  petsc_check(EPSSetType(eps, EPSARNOLDI));
  petsc_check(EPSSetWhichEigenpairs(eps, EPS_LARGEST_MAGNITUDE));
  // One Arnoldi factorisation of that many periods, all of whose Ritz values are taken.
  petsc_check(EPSSetDimensions(eps, options.periods - 1, options.periods, PETSC_DEFAULT));
  petsc_check(EPSSetTolerances(eps, 1e10, 1));
  Vec start = first;
  petsc_check(EPSSetInitialSpace(eps, 1, &start));
  petsc_check(EPSSetFromOptions(eps));
  petsc_check(EPSSolve(eps));
  PetscInt found = 0;
  petsc_check(EPSGetConverged(eps, &found));
  if (found < map.motion_size()) throw SolveError("the Floquet multipliers did not converge");
  FloquetMultipliers result;
  for (PetscInt n = 0; n < found; ++n) {
    PetscScalar real = 0.0, imaginary = 0.0;
    petsc_check(EPSGetEigenvalue(eps, n, &real, &imaginary));
    const std::complex<double> multiplier(real, imaginary);
    if (n < map.motion_size()) {
      result.gear_pair.push_back(multiplier);
    } else {
      result.film_bound = std::max(result.film_bound.value_or(0.0), std::abs(multiplier));
    }
  }
  return result;
}

}  // namespace gearfilm
