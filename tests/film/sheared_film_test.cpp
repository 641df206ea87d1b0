// Films that feel a shear law: their Jacobian, the limits of the law, what thins them.
#include <gtest/gtest.h>

#include <algorithm>

#include "placed_film.hpp"
#include "traction/coupled_film.hpp"
#include "traction/sheared_flow.hpp"

namespace gearfilm {
namespace {

TractionModel sheared(ShearLawKind kind) {
  TractionModel model;
  model.law.kind = kind;
  model.shear_couples_film = true;
  return model;
}

struct ShearedFilm : PlacedFilm {
  ShearedFilm(double xi, int nx, int ny, const TractionModel& model)
      : PlacedFilm(xi, 1.0, nx, ny), coupled(solve_coupled(*film, load, SolverOptions{}, model, result)) {}

  double factor() const { return coupled.film.quantities.central_film / result.quantities.central_film; }

  CoupledFilm coupled;
};

TEST(ShearedFilm, jacobian_knows_the_correction) {
  const ShearedFilm film(0.005, 129, 33, sheared(ShearLawKind::eyring));
  expect_second_order(*film.film, film.coupled.film.solution);
}

TEST(ShearedFilm, of_a_stress_that_nothing_reaches_is_newtonian) {
  TractionModel stiff = sheared(ShearLawKind::eyring);
  stiff.law.eyring_stress = 1e30;
  const ShearedFilm film(0.002, 65, 33, stiff);
  EXPECT_NEAR(film.factor(), 1.0, 1e-9);
  EXPECT_EQ(*std::ranges::min_element(film.film->flow_factors().cross_flow), 1.0);
}

// Stresses of the inlet are below tau_0: a few per cent.
TEST(ShearedFilm, is_thinner_the_softer_the_oil) {
  double before = 1.01;
  for (const double stress : {1.6e7, 8e6, 4e6}) {
    TractionModel model = sheared(ShearLawKind::eyring);
    model.law.eyring_stress = stress;
    const ShearedFilm film(0.005, 129, 33, model);
    EXPECT_LT(film.factor(), before - 0.005);
    EXPECT_LT(film.coupled.change, 1e-3);
    before = film.factor();
  }
  EXPECT_GT(before, 0.8);
}

// The correction that a film keeps is that of its own state.
TEST(ShearedFilm, has_the_flow_of_its_own_shear) {
  const TractionModel model = sheared(ShearLawKind::carreau);
  const ShearedFilm film(0.005, 65, 33, model);
  const FlowFactors& kept = film.film->flow_factors();
  const FlowFactors own = sheared_flow(model, *film.film);
  const Grid& grid = film.grid;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      if (film.film->total_pressure().row(i)[j] < 0.05) continue;
      const std::size_t n = static_cast<std::size_t>(i) * grid.y_count() + j;
      EXPECT_NEAR(kept.shear_index[n], own.shear_index[n], 0.02);
      EXPECT_NEAR(kept.cross_flow[n], own.cross_flow[n], 0.02);
    }
  }
}

}  // namespace
}  // namespace gearfilm
