// The stationary solver from nothing, with its default options, over the range of loads, oils and shapes.
#include <sstream>
#include <tuple>

#include "film_case.hpp"

namespace gearfilm {
namespace {

class SlowRobustness : public testing::TestWithParam<std::tuple<double, double, double>> {
protected:
  static void SetUpTestSuite() {
    report("     M    L     D     nx x ny    H_central      H_min  Newton  Krylov  (finest grid)  seconds");
  }
};

// M = 2400 with D = 1 may have H <= 0 on this grid: only convergence is asked for.
TEST_P(SlowRobustness, stationary_film_converges_from_nothing) {
  const auto [M, L, D] = GetParam();
  const FilmCase film_case = moes_contact(M, L, D);
  const int ny = D == 1.0 ? 129 : 65;
  const double start = MPI_Wtime();
  try {
    const SolvedFilm solved(PETSC_COMM_WORLD, film_case, 129, ny);
    const auto& [solution, quantities, counts, by_grid, before] = solved.result;
    report("%6.0f %4.0f  %4.2f    129 x %-3d  %10.6f %10.6f  %6d  %6d  %21.2f", M, L, D, ny, quantities.central_film,
           quantities.smallest_film, counts.newton, counts.krylov, MPI_Wtime() - start);
    const double force = film_case.scales.static_force;
    EXPECT_NEAR(quantities.pressure_integral, force, 1e-6 * force);
    EXPECT_TRUE(quantities.finite);
    if (M < 2400.0) {
      EXPECT_GT(quantities.smallest_film, 0.0);
    }
  } catch (const SolveError& error) {
    ADD_FAILURE() << "M = " << M << ", L = " << L << ", D = " << D << ": " << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(loads_oils_and_shapes, SlowRobustness,
                         testing::Combine(testing::Values(20.0, 200.0, 800.0, 2400.0), testing::Values(5.0, 10.0, 27.0),
                                          testing::Values(1.0, 0.3, 0.06)),
                         [](const auto& tested) {
                           std::ostringstream name;
                           name << "M" << std::get<0>(tested.param) << "_L" << std::get<1>(tested.param) << "_D"
                                << std::lround(100.0 * std::get<2>(tested.param)) << "_percent";
                           return name.str();
                         });

}  // namespace
}  // namespace gearfilm
