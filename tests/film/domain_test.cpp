// Domain and steps that follow from the film to be expected, and the error that a film says its grid has.
#include <numbers>

#include "film/expected_errors.hpp"
#include "film_case.hpp"
#include "grid/load_beyond_edges.hpp"
#include "solver/grid_error.hpp"

namespace gearfilm {
namespace {

class ChoiceFor : public testing::TestWithParam<std::array<double, 3>> {
protected:
  const FilmCase contact = moes_contact(GetParam()[0], GetParam()[1], GetParam()[2]);
  const ExpectedFilm expected{contact.scales};
};

TEST_P(ChoiceFor, steps_keep_both_errors_within_the_accuracy) {
  for (const auto by : {FilmDiscretisation::fitted, FilmDiscretisation::central}) {
    double coarser = HUGE_VAL;
    for (const double accuracy : {0.05, 0.02, 0.005}) {
      const Steps steps = steps_for(by, expected, accuracy);
      const FilmErrors errors = expected_errors(by, expected, steps);
      EXPECT_LE(errors.central, accuracy * (1.0 + 1e-12));
      EXPECT_LE(errors.smallest, accuracy * (1.0 + 1e-12));
      EXPECT_GT(std::max(errors.central, errors.smallest), 0.7 * accuracy);  // and no finer than that
      EXPECT_LT(steps.x, coarser);
      coarser = steps.x;
    }
  }
}

TEST_P(ChoiceFor, domain_has_the_ellipse_and_an_inlet_before_it) {
  const Domain domain = domain_of(expected);
  EXPECT_LT(domain.x_min, -1.0 - flooded_inlet(expected));
  EXPECT_GT(domain.x_max, 1.1);
  EXPECT_GT(domain.y_half, clear_side(expected));
  EXPECT_GT(clear_side(expected), 1.0);
}

// Both loads by the pressures of rigid cylinders, p = 6 eta u x/h^2 summed up to its largest and p = 6 eta V R/h^2, in
// strips from the edge on; the wedge's factor 4.9 is that of the rigid limit of Moes' line contact, 2.45 (u_1 + u_2).
TEST_P(ChoiceFor, load_beyond_the_edges_is_that_of_rigid_strips) {
  const Scales& scales = contact.scales;
  const double V = 3.0, c = 0.5 * scales.radius_ratio / std::pow(scales.hertz.ellipticity, 2), H = expected.film;
  if (H > 0.9 * c) return;  // no tips
  const LoadBeyondEdges load(scales, V);
  const double wedge = 4.9 / 12.0, approach = 3.0 * std::numbers::sqrt2 * std::numbers::pi / 12.0;
  const double share = 2.0 * scales.lambda / scales.static_force / scales.hertz.ellipticity;  // of a strip, both sides
  for (const double edge : {1.2, 1.7}) {
    double sum = 0.0;
    const int points = 20000;
    for (int n = 0; n < points; ++n) {
      const double z = (n + 0.5) / points, y = edge / z, gap = H + c * (y * y - 1.0);
      sum += (wedge / gap + approach * V / std::pow(gap, 1.5)) * edge / (z * z * points);
    }
    EXPECT_NEAR(load.sides(edge) / (share * sum), 1.0, 0.02) << edge;
  }
  EXPECT_LT(load.outlet(1.8), 0.5 * load.outlet(1.25));
  EXPECT_DOUBLE_EQ(LoadBeyondEdges(scales, 0.0).outlet(1.25), 0.0);
  EXPECT_DOUBLE_EQ(LoadBeyondEdges(scales, 1.0, V).outlet(1.8), load.outlet(1.8));
}

TEST_P(ChoiceFor, domain_of_a_pair_leaves_little_load_out_and_stays_on_the_face) {
  const Domain alone = domain_of(expected);
  for (const double velocity : {0.0, 1.0, 20.0}) {
    const LoadBeyondEdges load(contact.scales, velocity, 2.0);
    const Domain longer = carrying_behind(alone, load);
    EXPECT_GE(longer.x_max, alone.x_max);
    EXPECT_LE(load.outlet(longer.x_max), 0.015);
    for (const double half_face : {1.05, 1.6, 4.0}) {
      const Domain domain = carrying_beside(longer, load, half_face);
      EXPECT_EQ(domain.x_min, alone.x_min);
      EXPECT_GE(domain.y_half, alone.y_half);
      EXPECT_LE(domain.y_half, std::max(alone.y_half, half_face));
      if (domain.y_half < half_face) {
        EXPECT_LE(load.sides(domain.y_half) - load.sides(half_face), 0.002 + 1e-9);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(contacts, ChoiceFor,
                         testing::Values(std::array{2e5, 5.0, 0.001}, std::array{2.5e4, 12.0, 0.0035},
                                         std::array{2400.0, 27.0, 0.06}, std::array{100.0, 10.0, 0.5},
                                         std::array{20.0, 10.0, 1.0}));

// Rigid cylinders, at which the film ends 0.475 sqrt(2 R_x h) behind the middle.
TEST(Choice, outlets_lie_behind_the_rupture_of_thick_films) {
  for (const double M : {0.5, 2.0, 20.0}) {
    const ExpectedFilm expected(moes_contact(M, 20.0, 0.5).scales);
    const double rupture = 0.475 * std::sqrt(2.0 * expected.film);
    EXPECT_GT(domain_of(expected).x_max, 1.2 * rupture) << M;
  }
  const ExpectedFilm thick(moes_contact(0.5, 20.0, 0.5).scales);
  EXPECT_GT(domain_of(thick).x_max, 1.25);
  EXPECT_DOUBLE_EQ(pressure_length(thick), std::pow(thick.film, 2.0 / 3.0));
}

TEST(Choice, films_that_would_tear_have_no_finite_error) {
  const ExpectedFilm expected(moes_contact(2e5, 5.0, 0.001).scales);
  for (const auto by : {FilmDiscretisation::fitted, FilmDiscretisation::central}) {
    const Steps steps = steps_for(by, expected, 0.02);
    EXPECT_EQ(expected_errors(by, expected, {steps.x, 3.0 * steps.y}).smallest, HUGE_VAL);
  }
}

TEST(Choice, nodes_can_be_halved) {
  for (const double length : {1.0, 3.3, 40.0}) {
    const int nodes = nodes_along(length, 0.026);
    EXPECT_EQ((nodes - 1) % 16, 0);
    EXPECT_GE(nodes, 65);
    EXPECT_LE(length / (nodes - 1), 0.026);
    const int across = nodes_across(length, 0.026);
    EXPECT_EQ((across - 1) % 8, 0);
    EXPECT_GE(across, 17);
    EXPECT_LE(length / (across - 1), 0.026);
  }
}

// Limits of the study of docs/verification.md, section 4, on the paper's short domain.
class ErrorsOfGrids : public testing::TestWithParam<FilmDiscretisation> {};

TEST_P(ErrorsOfGrids, hold_the_film_of_an_infinitely_fine_grid) {
  const FilmCase pitch = table3_pitch();
  const bool fitted = GetParam() == FilmDiscretisation::fitted;
  const int nx = fitted ? 65 : 129;
  const SolvedFilm coarse(PETSC_COMM_WORLD, pitch, nx, 65, {}, Edge::symmetry, GetParam()),
      fine(PETSC_COMM_WORLD, pitch, 2 * nx - 1, 129, {}, Edge::symmetry, GetParam());
  const LoadCondition load = LoadCondition::force(pitch.scales.static_force);
  const auto of_coarse = grid_errors(coarse.film, load, {}, coarse.result);
  const auto of_fine = grid_errors(fine.film, load, {}, fine.result);
  ASSERT_TRUE(of_coarse && of_fine);
  for (const auto quantity : {&GridErrors::central_film, &GridErrors::smallest_film}) {
    const Estimate &first = (*of_coarse).*quantity, &second = (*of_fine).*quantity;
    report("%s: %d lines %.4f +- %.4f, extrapolated %.4f; twice as many %.4f +- %.4f, extrapolated %.4f",
           GetParam() == FilmDiscretisation::fitted ? "fitted" : "central", coarse.grid.nx(), first.value, first.error,
           *first.extrapolated, second.value, second.error, *second.extrapolated);
    EXPECT_LE(std::abs(*second.extrapolated - first.value), 1.1 * first.error);
    EXPECT_LE(second.error, fitted ? first.error : 0.5 * first.error);  // fitted: the least bar
    EXPECT_NEAR(*first.extrapolated, *second.extrapolated, second.error + first.error);
  }
  EXPECT_EQ(of_coarse->central_film.value, coarse.result.quantities.central_film);
}

INSTANTIATE_TEST_SUITE_P(both, ErrorsOfGrids, testing::Values(FilmDiscretisation::fitted, FilmDiscretisation::central),
                         [](const auto& tested) {
                           return tested.param == FilmDiscretisation::fitted ? "fitted" : "central";
                         });

TEST(GridErrors, are_unknown_where_half_the_nodes_have_no_film) {
  const FilmCase thin = moes_contact(2e5, 5.0, 0.001);
  const SolvedFilm solved(PETSC_COMM_WORLD, thin, 129, 65, {}, Edge::symmetry, FilmDiscretisation::central);
  EXPECT_FALSE(grid_errors(solved.film, LoadCondition::force(thin.scales.static_force), {}, solved.result));
}

}  // namespace
}  // namespace gearfilm
