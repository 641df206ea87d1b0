#include "bench/grid_bench.hpp"

#include "bench/bench_pair.hpp"
#include "bench/convolution_time.hpp"
#include "bench/kernel_time.hpp"
#include "bench/stopwatch.hpp"
#include "film/multigrid_level.hpp"
#include "input/case_setup.hpp"
#include "output/summary.hpp"
#include "solver/stationary.hpp"
#include "traction/sheared_flow.hpp"

namespace gearfilm {
namespace {

constexpr int kernel_runs = 41;
constexpr int solve_runs = 3;

/// The measurements on one grid.
class GridBench {
public:
  GridBench(MPI_Comm comm, const CaseInput& problem)
      : comm_(comm),
        problem_(problem),
        discretisation_(discretise(comm, problem)),
        film_(discretisation_, problem.scales, problem.numerics.solver.multigrid),
        unit_(common_unit(comm, size_of(problem))),
        change_(film_.grid().local_size()),
        rows_(film_.grid().local_size()) {}

  Summary run() {
    petsc_check(PetscPrintf(comm_, "\n%d x %d nodes, convolution time %.4g ms\n%-28s %12s %10s %12s\n",
                            film_.grid().nx(), film_.grid().ny(), 1e3 * unit_, "", "time [ms]", "ns/node",
                            "convolutions"));
    solve();
    kernels<float>("single");
    kernels<double>("double");
    film_kernels();
    traction_kernels();
    return {{"nx", film_.grid().nx()}, {"ny", film_.grid().ny()}, {"convolution_time", unit_}, {"rows", table_}};
  }

private:
  template <class Work>
  void time(const std::string& name, int runs, Work work) {
    double seconds = median_time(work, 0.0, 0, runs);
    MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, comm_);
    const KernelTime took{name, seconds, static_cast<double>(film_.grid().nx()) * film_.grid().ny(), unit_};
    petsc_check(PetscPrintf(comm_, "%-28s %12.4g %10.3g %12.3g\n", name.c_str(), 1e3 * seconds, took.ns_per_node(),
                            took.convolutions()));
    table_.push_back(as_summary(kernel_members, took));
  }

  template <class Work>
  void time(const std::string& name, Work work) {
    time(name, kernel_runs, work);
  }

  void solve() {
    const LoadCondition load = LoadCondition::force(problem_.scales.static_force);
    time("stationary film", solve_runs, [&] { result_ = solve_stationary(film_, load, problem_.numerics.solver); });
  }

  template <class Real>
  void kernels(const std::string& precision) {
    MultigridLevel<Real> level(*discretisation_);
    const Deformation<Real>& deformation = discretisation_->prepare_deformation<Real>();
    Field<Real> pressure(film_.grid()), deformed(film_.grid());
    time("deformation, " + precision, [&] { deformation.apply(pressure, deformed); });
    time("smoother factors, " + precision, [&] { level.update(film_.state(), 0.0); });
    time("smoother sweep, " + precision, [&] { level.smooth(rows_, change_, 1, true); });
  }

  void film_kernels() {
    FilmSolution& solution = result_.solution;
    time("film and residual", [&] { film_.residual(solution.pressure, solution.H0, {}, rows_); });
    constexpr StateVersion same = ~StateVersion(0);  // the film is evaluated once
    time("linearisation, all levels", [&] { film_.linearise(solution.pressure, solution.H0, {}, 0.0, same); });
    time("Jacobian application", [&] { film_.multiply(rows_, 0.0, change_); });
    time("V-cycle", [&] { film_.precondition(rows_, change_); });
  }

  /// On a film that slides by a fifth of its entrainment, in the case's own oil or a typical one.
  void traction_kernels() {
    constexpr double typical_step = 1e-6;  // s
    TractionModel model = warm_film(problem_);
    const HeatOptions heat = *model.heat;
    move_surfaces(film_, {.sliding = 0.2});
    film_.evaluate(result_.solution.pressure, result_.solution.H0);
    model.heat.reset();
    time("friction", [&] { traction(model, film_); });
    model.heat = heat;
    model.heat->couple_film = false;
    time("heat across the film", [&] { traction(model, film_); });
    model.heat->couple_film = true;
    FilmHeat warm, again;
    coupled_traction(model, film_, warm);  // the first sweep begins cold
    time("heat of a film that feels it", [&] {
      again = warm;
      coupled_traction(model, film_, again, typical_step);
    });
    time("flow by the shear law", [&] { sheared_flow(model, film_); });
  }

  MPI_Comm comm_;
  const CaseInput& problem_;
  SharedDiscretisation discretisation_;
  ContactFilm film_;
  double unit_;
  StationaryResult result_;
  std::vector<double> change_, rows_;
  Summary table_ = Summary::array();
};

}  // namespace

Summary bench_grid(MPI_Comm comm, const CaseInput& problem) { return GridBench(comm, problem).run(); }

}  // namespace gearfilm
