#include "solver/stationary_newton.hpp"

#include <algorithm>
#include <sstream>

#include "film/expected_errors.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

const Tuned<int> most_free("stationary_most_free", 12, "Newton iterations of a pseudo-time step with free changes");
const Tuned<int> most_limited("stationary_most_limited", 40,
                              "Newton iterations of a pseudo-time step with limited changes");
constexpr double thinnest = 0.1;  // film before a pseudo-time step, of the expected central one

/// A linear solve between rough surfaces that leaves much has nodes at the front full or dry by mistake.
NewtonOptions between_surfaces(const Scales& scales, NewtonOptions options) {
  constexpr double tightest = 1e-3;
  if (scales.solids.rough) options.tightest_krylov_tolerance = std::min(options.tightest_krylov_tolerance, tightest);
  return options;
}

}  // namespace

StationaryNewton::StationaryNewton(const std::vector<ContactFilm*>& films, const NewtonOptions& options)
    : system_(films, fixed_approach(0.0, films.size())),
      state_(system_.create_state()),
      residual_(system_.create_state()),
      rate_(system_.create_state()),
      jacobian_(shell_jacobian(system_)),
      tolerance_(options.tolerance),
      max_iterations_(options.max_iterations),
      watcher_(options.watcher) {
  petsc_check(SNESCreate(system_.comm(), snes_.put()));
  petsc_check(SNESSetOptionsPrefix(snes_, "steady_"));
  petsc_check(SNESSetFunction(
      snes_, residual_,
      [](SNES, Vec state, Vec residual, void* context) -> PetscErrorCode {
        return petsc_callback([&] { static_cast<StationaryNewton*>(context)->evaluate(state, residual); });
      },
      this));
  petsc_check(SNESSetJacobian(
      snes_, jacobian_, jacobian_,
      [](SNES, Vec state, Mat matrix, Mat, void* context) -> PetscErrorCode {
        return petsc_callback([&] {
          static_cast<StationaryNewton*>(context)->update_jacobian(state);
          petsc_check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
          petsc_check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
        });
      },
      this));
  configure_newton(snes_, system_, between_surfaces(films.front()->scales(), options), system_.weight());
  limit_changes(options.limit_changes ? Changes::limited : Changes::free);
  petsc_check(SNESSetFromOptions(snes_));
  if (watcher_) watch();
}

// Where fronts move, Newton's way between rough surfaces leads up first; no gap changes by more than sigma in a step.
void StationaryNewton::limit_changes(Changes changes) {
  changes_ = changes;
  gearfilm::limit_changes(snes_, system_, changes);
  if (system_.film(0).scales().solids.rough) allow_growth(snes_, system_, Growth::tenfold);
}

// A linear solve of a large grid takes seconds, too.
void StationaryNewton::watch() {
  petsc_check(SNESMonitorSet(
      snes_,
      [](SNES, PetscInt iteration, PetscReal norm, void* context) -> PetscErrorCode {
        return petsc_callback([&] {
          auto& own = *static_cast<StationaryNewton*>(context);
          own.watched_ = {iteration, norm / own.system_.weight()};
          own.tell(0);
        });
      },
      this, nullptr));
  KSP ksp = nullptr;
  petsc_check(SNESGetKSP(snes_, &ksp));
  petsc_check(KSPMonitorSet(
      ksp,
      [](KSP, PetscInt iteration, PetscReal, void* context) -> PetscErrorCode {
        return petsc_callback([&] { static_cast<StationaryNewton*>(context)->tell(iteration); });
      },
      this, nullptr));
}

void StationaryNewton::tell(PetscInt krylov) {
  const Grid& grid = system_.film(0).grid();
  std::ostringstream text;
  text << "stationary film, " << grid.nx() << " x " << grid.ny() << " nodes";
  text.precision(2);
  if (step_) text << ", pseudo-time step " << 1.0 / step_->shift;
  text << ": Newton iteration " << watched_.newton << ", residual " << watched_.residual;
  if (krylov > 0) text << ", Krylov iteration " << krylov;
  watcher_(text.str());
}

FilmSystem::Rate StationaryNewton::rate_at(Vec state) {
  if (!step_) return {};
  system_.transient(state, rate_);
  const VecWriting rates(rate_);
  for (std::size_t n = 0; n < step_->mass.size(); ++n) rates[n] = step_->shift * (rates[n] - step_->mass[n]);
  return {rate_, step_->shift};
}

void StationaryNewton::evaluate(Vec state, Vec residual) { system_.residual(state, rate_at(state), residual); }

void StationaryNewton::update_jacobian(Vec state) {
  const FilmSystem::Rate rate = rate_at(state);
  system_.linearise(state, rate, rate.shift, elimination_);
}

long StationaryNewton::convolutions() {
  long sum = 0;
  for (std::size_t k = 0; k < system_.films(); ++k) sum += system_.film(k).convolutions();
  return sum;
}

// A displacement that is given depends on no film: on rigid solids it comes first, exactly.
void StationaryNewton::begin(const LoadCondition& load, const FilmSolution& films) {
  const bool given = load.kind == LoadCondition::Kind::displacement;
  elimination_ = given ? FilmSystem::BlockElimination::scalars_first : FilmSystem::BlockElimination::exact;
  const auto held = given ? fixed_approach : load_balance;
  system_.set_bodies(held(load.value, system_.films()), load.compliance);
  const std::span pressures(films.pressure);
  const std::size_t size = pressures.size() / system_.films();
  for (std::size_t k = 0; k < system_.films(); ++k) system_.set_field(state_, k, pressures.subspan(k * size, size));
  system_.set_scalars(state_, std::span(&films.H0, 1));
}

FilmSolution StationaryNewton::films() const {
  FilmSolution films;
  for (std::size_t k = 0; k < system_.films(); ++k) {
    const std::vector<double> pressure = system_.field(state_, k);
    films.pressure.insert(films.pressure.end(), pressure.begin(), pressure.end());
  }
  films.H0 = system_.scalars(state_).front();
  return films;
}

std::vector<double> StationaryNewton::mass_of_state() {
  system_.transient(state_, rate_);
  const VecReading values(rate_);
  const auto mass = values.values().first(static_cast<std::size_t>(system_.pressure_count()));
  return {mass.begin(), mass.end()};
}

bool StationaryNewton::iterate() {
  const long before = convolutions();
  petsc_check(SNESSolve(snes_, nullptr, state_));
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  PetscInt newton = 0, krylov = 0;
  petsc_check(SNESGetConvergedReason(snes_, &reason));
  petsc_check(SNESGetIterationNumber(snes_, &newton));
  petsc_check(SNESGetLinearSolveIterations(snes_, &krylov));
  PetscReal norm = 0.0;
  petsc_check(SNESGetFunctionNorm(snes_, &norm));
  counts_.newton += newton;
  counts_.krylov += krylov;
  counts_.convolutions += convolutions() - before;
  counts_.residual = norm / system_.weight();
  return reason > 0;
}

// Where a guess lets the bodies overlap, as dry contacts do at the corners of a face, no film could follow from what is
// less than nothing: oil is put there.
bool StationaryNewton::step(double shift) {
  const double least = thinnest * ExpectedFilm(system_.film(0).scales()).film;
  mass_ = mass_of_state();
  for (double& mass : mass_) mass = std::max(mass, least);
  step_ = ImplicitStep{shift, mass_};
  const int most = changes_ == Changes::free ? most_free : most_limited;
  allow_iterations(snes_, std::min(most, max_iterations_));
  return iterate();
}

bool StationaryNewton::solve(const LoadCondition& load, FilmSolution& guess, const std::optional<ImplicitStep>& step) {
  begin(load, guess);
  step_ = step;
  allow_iterations(snes_, max_iterations_);
  const bool found = iterate();
  guess = films();
  return found;
}

}  // namespace gearfilm
