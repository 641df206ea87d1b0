#include "gearfilm/orbits/dynamic_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearfilm/ehl/integral.hpp"
#include "gearfilm/ehl/oscillating_film.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/orbits/mode_solver.hpp"
#include "gearfilm/parallel/dense_factors.hpp"

namespace gearfilm {
namespace {

/// Rates |s| over the entrainment from which relaxation is the preconditioner. The number of its iterations falls with
/// the rate, as that of the smoother in short time steps does.
constexpr double fast_oscillation = 2.0;

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
    oscillating_.update(film_.state(), film_.conditions().entrainment, s);
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

std::complex<double> film_stiffness(FilmResponse& response, const SwingOptions& options) {
  const OwnedMat matrix = shell_jacobian(response);
  OwnedVec column, change;
  petsc_check(MatCreateVecs(matrix, change.put(), column.put()));
  response.displacement_column(column);
  ModeSolver(response, matrix, options.krylov_tolerance, options.krylov_max_iterations, "the films' dynamic stiffness",
             options.watcher)
      .apply(column, change);
  return response.force(change);
}

/// Sum of F of (I + K C) F = K with complex K, as a real system of (Re F, Im F).
std::complex<double> settled(const std::vector<std::complex<double>>& K, const Compliance& compliance) {
  const std::size_t n = K.size();
  std::vector<double> right_side(2 * n), matrix(4 * n * n);
  for (std::size_t k = 0; k < n; ++k) {
    right_side[k] = K[k].real();
    right_side[n + k] = K[k].imag();
    for (std::size_t j = 0; j < n; ++j) {
      const std::complex<double> entry = (k == j ? 1.0 : 0.0) + K[k] * compliance(k, j);
      matrix[k * 2 * n + j] = matrix[(n + k) * 2 * n + n + j] = entry.real();
      matrix[(n + k) * 2 * n + j] = entry.imag();
      matrix[k * 2 * n + n + j] = -entry.imag();
    }
  }
  DenseFactors factors;
  factors.factor(matrix);
  const std::vector<double> forces = factors.solve(right_side);
  std::complex<double> sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) sum += std::complex<double>(forces[k], forces[n + k]);
  return sum;
}

}  // namespace

std::complex<double> dynamic_stiffness(LubricatedPair& pair, Vec state, std::complex<double> s,
                                       const SwingOptions& options) {
  FilmSystem& system = pair.system();
  const std::vector<double> displaced = system.displacements(state);
  std::vector<std::complex<double>> each;
  for (std::size_t k = 0; k < system.films(); ++k) {
    const std::vector<double> pressure = system.field(state, k);
    FilmResponse response(system.film(k), pressure, displaced[k], s);
    each.push_back(film_stiffness(response, options));
  }
  return settled(each, system.compliance());
}

std::complex<double> swinging_mode(LubricatedPair& pair, Vec state, const SwingOptions& options) {
  const MeshModel& mesh = pair.mesh();
  pair.place(0.0);
  const auto residual = [&](std::complex<double> s) {
    return mesh.inertia * s * s + dynamic_stiffness(pair, state, s, options);
  };
  std::complex<double> before(0.0, 2.0 * std::numbers::pi * mesh.frequency());
  std::complex<double> s = before * std::complex<double>(1.0, 0.01);  // a little damped
  std::complex<double> residual_before = residual(before);
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    const std::complex<double> now = residual(s);
    const std::complex<double> step = now * (s - before) / (now - residual_before);
    before = s;
    residual_before = now;
    s -= step;
    if (std::abs(step) > options.tolerance * std::abs(s)) continue;
    if (s.imag() > options.tolerance * std::abs(s)) return s;
    throw SolveError("the pair does not swing on its films: they damp it beyond any oscillation");
  }
  throw SolveError("no mode of the pair on its films found near its natural frequency");
}

}  // namespace gearfilm
