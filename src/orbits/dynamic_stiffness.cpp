#include "orbits/dynamic_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/dense.hpp"
#include "film/oscillating_film.hpp"
#include "gearfilm/error.hpp"
#include "grid/integral.hpp"
#include "numerics/tuned.hpp"
#include "orbits/mode_solver.hpp"

namespace gearfilm {
namespace {

/// Rates |s| over the entrainment from which relaxation is the preconditioner. The number of its iterations falls with
/// the rate, as that of the smoother in short time steps does.
const Tuned<double> fast_oscillation("modes_fast_oscillation", 2.0,
                                     "rate over the entrainment from which relaxation is the preconditioner");

const Tuned<double> loosest_solution("modes_loosest_solution", 1e-4,
                                     "loosest tolerance of the secant method's solutions");
const Tuned<double> tighter_than_step("modes_tighter_than_step", 1e-3,
                                      "tolerance of a solution in the last change of the rate");
const Tuned<double> told_by_solutions("modes_told_by_solutions", 30.0,
                                      "change of the rate over the tolerance from which secants have a slope");

/// (A + s B) of one film on p = [x, y], with s = sigma + i omega.
/// Fast oscillations are preconditioned with one complex line relaxation. Slow ones, whose long waves that leaves, in
/// real arithmetic on all levels:
///   (A + sigma B) x - omega B y = f ,   omega B x + (A + sigma B) y = g
/// with A + (sigma + 2 omega) B in the lower right corner. Then x + y and y follow one after the other from the real
/// M = A + (sigma + omega) B, for which the film's own preconditioner stands:
///   M (x + y) = f + g ,   M y = g - omega B (x + y)
class FilmResponse final : public LinearisedSystem {
public:
  FilmResponse(ContactFilm& film, std::span<const double> pressure, double H0, std::complex<double> s)
      : film_(film),
        omega_(s.imag()),
        fast_(std::abs(s) > fast_oscillation * film.conditions().entrainment),
        size_(pressure.size()),
        sum_(size_),
        mass_(size_),
        oscillating_(*film.discretisation()) {
    film_.linearise(pressure, H0, {}, std::max(0.0, s.real() + s.imag()));
    oscillating_.update(film_.state(), s);
  }

  MPI_Comm comm() const override { return film_.grid().comm(); }
  PetscInt local_size() const override { return static_cast<PetscInt>(2 * size_); }
  PetscInt pressure_count() const override { return local_size(); }

  void multiply(Vec change, Vec rows) override {
    oscillating_.multiply(VecReading(change).values(), VecWriting(rows).values());
  }

  /// a + s b.
  void displacement_column(Vec column) { oscillating_.displacement_column(VecWriting(column).values()); }

  void precondition(Vec rows, Vec change) override {
    const VecReading in(rows);
    const VecWriting out(change);
    if (fast_) {
      oscillating_.relax(in.values(), out.values());
    } else {
      precondition_on_all_levels(in.values(), out.values());
    }
  }

  std::complex<double> force(Vec change) const {
    const VecReading in(change);
    return {integral(film_.grid(), in.values().first(size_)), integral(film_.grid(), in.values().subspan(size_))};
  }

private:
  void precondition_on_all_levels(std::span<const double> in, std::span<double> out) {
    const auto x = out.first(size_), y = out.subspan(size_);
    for (std::size_t n = 0; n < size_; ++n) sum_[n] = in[n] + in[size_ + n];
    film_.precondition(sum_, x);
    film_.multiply_mass(x, 0.0, mass_);
    for (std::size_t n = 0; n < size_; ++n) sum_[n] = in[size_ + n] - omega_ * mass_[n];
    film_.precondition(sum_, y);
    for (std::size_t n = 0; n < size_; ++n) x[n] -= y[n];
  }

  ContactFilm& film_;
  double omega_;
  bool fast_;
  std::size_t size_;
  std::vector<double> sum_, mass_;
  OscillatingFilm oscillating_;
};

}  // namespace

/// p of one film at the last two s, from which those at further s begin: p is analytic in s, so that a line through
/// two of them is one with a complex slope.
class DynamicStiffness::Memory {
public:
  /// Puts a guess into change, which has the size of p.
  void guess(std::complex<double> s, Vec change) const {
    const VecWriting out(change);
    const std::span<double> p = out.values();
    if (last_.empty()) {
      std::ranges::fill(p, 0.0);
      return;
    }
    std::ranges::copy(last_, p.begin());
    if (before_.empty()) return;
    const std::complex<double> ahead = (s - last_s_) / (last_s_ - before_s_);
    const std::size_t size = p.size() / 2;
    for (std::size_t n = 0; n < size; ++n) {
      const std::complex<double> difference(last_[n] - before_[n], last_[size + n] - before_[size + n]);
      p[n] += (ahead * difference).real();
      p[size + n] += (ahead * difference).imag();
    }
  }

  /// Keeps p at s; at an s that it has, in the place of that.
  void keep(std::complex<double> s, Vec change) {
    if (!last_.empty() && s != last_s_) {
      before_.swap(last_);
      before_s_ = last_s_;
    }
    const VecReading in(change);
    last_.assign(in.values().begin(), in.values().end());
    last_s_ = s;
  }

private:
  std::vector<double> last_, before_;
  std::complex<double> last_s_, before_s_;
};

class DynamicStiffness::Films {
public:
  Films(LubricatedPair& pair, Vec state, const SwingOptions& options)
      : system_(pair.system()), state_(state), options_(options), memories_(system_.films()) {}

  std::complex<double> at(std::complex<double> s, double krylov_tolerance) {
    const Eigen::VectorXd displaced = system_.displacements(state_);
    Eigen::VectorXcd stiffness(displaced.size());
    for (std::size_t k = 0; k < system_.films(); ++k) {
      const std::vector<double> pressure = system_.field(state_, k);
      FilmResponse response(system_.film(k), pressure, displaced[k], s);
      stiffness[k] = of_film(response, s, krylov_tolerance, memories_[k]);
    }
    return solved_complex(system_.compliance().coupling_matrix(stiffness), stiffness).sum();
  }

  int solutions() const { return solutions_; }
  int krylov_iterations() const { return krylov_iterations_; }

private:
  std::complex<double> of_film(FilmResponse& response, std::complex<double> s, double krylov_tolerance,
                               Memory& memory) {
    const OwnedMat matrix = shell_jacobian(response);
    OwnedVec column, change;
    petsc_check(MatCreateVecs(matrix, change.put(), column.put()));
    response.displacement_column(column);
    memory.guess(s, change);
    ++solutions_;
    ModeSolver solver(response, matrix, krylov_tolerance, options_.krylov_max_iterations,
                      "the films' dynamic stiffness (" + std::to_string(solutions_) + ")", options_.watcher);
    solver.use_guesses();
    krylov_iterations_ += solver.apply(column, change);
    memory.keep(s, change);
    return response.force(change);
  }

  FilmSystem& system_;
  Vec state_;
  const SwingOptions& options_;
  std::vector<Memory> memories_;
  int solutions_ = 0, krylov_iterations_ = 0;
};

DynamicStiffness::DynamicStiffness(LubricatedPair& pair, Vec state, const SwingOptions& options)
    : films_(std::make_unique<Films>(pair, state, options)) {}

DynamicStiffness::~DynamicStiffness() = default;

std::complex<double> DynamicStiffness::at(std::complex<double> s, double krylov_tolerance) {
  return films_->at(s, krylov_tolerance);
}

int DynamicStiffness::solutions() const { return films_->solutions(); }
int DynamicStiffness::krylov_iterations() const { return films_->krylov_iterations(); }

namespace {

double slowest_entrainment(FilmSystem& system) {
  double slowest = system.film(0).conditions().entrainment;
  for (std::size_t k = 1; k < system.films(); ++k) {
    slowest = std::min(slowest, system.film(k).conditions().entrainment);
  }
  return slowest;
}

}  // namespace

SwingingMode swinging_mode(LubricatedPair& pair, Vec state, const SwingOptions& options) {
  const MeshModel& mesh = pair.mesh();
  pair.place(0.0);
  DynamicStiffness stiffness(pair, state, options);
  std::complex<double> s = options.guess.value_or(std::complex<double>(0.0, 2.0 * std::numbers::pi * mesh.frequency()));
  std::complex<double> before = s, residual_before = 0.0, slope = 2.0 * mesh.inertia * s;
  double solved_to = std::max<double>(loosest_solution, options.krylov_tolerance), solved_before = solved_to;
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    const std::complex<double> residual = mesh.inertia * s * s + stiffness.at(s, solved_to);
    if (std::abs(s - before) > told_by_solutions * solved_before * std::abs(s)) {
      slope = (residual - residual_before) / (s - before);
    }
    const std::complex<double> step = residual / slope;
    const double change = std::abs(step) / std::abs(s);
    before = s;
    residual_before = residual;
    s -= step;
    const bool tight = solved_to <= options.krylov_tolerance;
    solved_before = solved_to;
    solved_to = std::clamp(tighter_than_step * change, options.krylov_tolerance, solved_to);
    if (!tight || change > options.tolerance) continue;
    if (s.imag() <= options.tolerance * std::abs(s)) {
      throw SolveError("the pair does not swing on its films: they damp it beyond any oscillation");
    }
    return {s, stiffness.solutions(), stiffness.krylov_iterations(), std::abs(s) / slowest_entrainment(pair.system())};
  }
  throw SolveError("no mode of the pair on its films found near its natural frequency");
}

}  // namespace gearfilm
