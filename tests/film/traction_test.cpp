// Friction and heat in films: the energy equation across a film against closed solutions, surfaces under known sources
// of heat, and the case study against an independent program.
#include "traction/traction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "film/face_flow.hpp"
#include "friction_reference.hpp"
#include "grid/integral.hpp"
#include "placed_film.hpp"
#include "traction/film_energy_equation.hpp"
#include "traction/moving_source.hpp"
#include "traction/tridiagonal_lanes.hpp"

namespace gearfilm {
namespace {

const Lubricant barus{.viscosity = 0.1, .pressure_viscosity = 2e-8, .viscosity_law = Barus{}};

/// A film between walls that stay cold, of oil that stays where it is.
FilmEnergyEquation couette(const ShearLaw& law, double sliding, int points) {
  const HeatOptions heat = heat_options(points);
  FilmEnergyEquation film(law, barus, heat);
  film.mean_velocity.fill(sliding);
  film.sliding.fill(sliding);
  film.conductance_pinion.fill(1e15);
  film.conductance_wheel.fill(1e15);
  film.full_film.fill(1.0);
  film.thickness.fill(1e-6);
  film.flow.fill(sliding);
  film.conductivity.fill(heat.oil.conductivity);
  film.base_pinion.fill(heat.oil.temperature);
  film.base_wheel.fill(heat.oil.temperature);
  for (auto* profiles : {&film.upstream, &film.before}) {
    for (FilmEnergyEquation::Lanes& T : *profiles) T.fill(heat.oil.temperature);
  }
  film.solve();
  return film;
}

/// eta_0 beta u_s^2/k is Nahme's number.
double sliding_of(double nahme) { return std::sqrt(nahme * 0.137 / (0.04 * barus.viscosity)); }

// Nahme 1940: tau h/(eta u_s) = asinh(c)/(c sqrt(1+c^2)), c^2 = Na/8, beta (T_mid - T_0) = ln(1 + Na/8).
TEST(FilmEnergyEquation, a_film_that_heats_itself_between_cold_walls) {
  const ShearLaw newtonian{.kind = ShearLawKind::newtonian, .limiting_ratio = 0.0};
  for (const double nahme : {5.84, 52.6, 584.0}) {
    const double c = std::sqrt(nahme / 8.0), expected = std::asinh(c) / (c * std::sqrt(1.0 + c * c));
    for (const auto& [points, tolerance] : {std::pair{81, 2e-4}, std::pair{17, 5e-3}}) {
      const FilmEnergyEquation film = couette(newtonian, sliding_of(nahme), points);
      EXPECT_NEAR(film.stress()[0] * 1e-6 / (barus.viscosity * sliding_of(nahme)), expected, tolerance * expected);
      const double middle = 0.04 * (film.temperatures()[points / 2][0] - heat_options(3).oil.temperature);
      EXPECT_NEAR(middle, std::log1p(nahme / 8.0), 10.0 * tolerance * middle) << nahme << " " << points;
    }
  }
}

// The same for any law: C = 1 + beta tau u_s^2/(8 k g_w), (h/2) sqrt(tau g_w beta C/(2 k)) = acosh sqrt(C), g_w the
// rate of shear at the walls.
TEST(FilmEnergyEquation, a_film_of_eyrings_oil_heats_itself) {
  const ShearLaw eyring{.limiting_ratio = 0.0};
  for (const double sliding : {10.0, 40.0}) {
    const FilmEnergyEquation film = couette(eyring, sliding, 81);
    const double stress = film.stress()[0], rate = fluidity(eyring, stress) / barus.viscosity;
    const double C = 1.0 + 0.04 * stress * sliding * sliding / (8.0 * 0.137 * rate);
    const double left = 0.5e-6 * std::sqrt(stress * rate * 0.04 * C / (2.0 * 0.137));
    EXPECT_NEAR(left, std::acosh(std::sqrt(C)), 3e-3 * left);
  }
}

/// The largest of a surface's rise over x under q(x) on -1 < x < 1, with nodes from -1.5 to 1.5.
template <class Source>
double largest_rise(Source source, int nodes) {
  const double h_x = 3.0 / (nodes - 1);
  const MovingSource moving(nodes, h_x);
  std::vector<double> heat, sum(1);
  for (int i = 0; i < nodes; ++i) heat.push_back(source(-1.5 + h_x * i));
  double largest = 0.0;
  for (int i = 0; i < nodes; ++i) {
    moving.earlier(heat, i, sum);
    largest = std::max(largest, sum[0] + moving.own_weight() * heat[i]);
  }
  return largest;
}

TEST(TridiagonalLanes, both_right_sides_are_met_in_every_lane) {
  for (const std::size_t rows : {3, 5, 17}) {
    std::vector<FilmLanes> below(rows), above(rows), diagonal(rows), first(rows), second(rows);
    for (std::size_t k = 0; k < rows; ++k) {
      each_lane([&](int l) {
        below[k][l] = k > 0 ? 1.0 + 0.1 * l : 0.0;
        above[k][l] = k + 1 < rows ? 1.5 - 0.05 * static_cast<double>(k) : 0.0;
        diagonal[k][l] = 3.0 + 0.2 * static_cast<double>(k) + l;
        first[k][l] = std::sin(1.0 + static_cast<double>(k) + l);
        second[k][l] = k == 1 ? 1.0 : 0.0;
      });
    }
    std::vector<FilmLanes> inverse = diagonal, x = first, y = second;
    solve_tridiagonal<2>(below, above, inverse, {&x, &y});
    for (std::size_t k = 0; k < rows; ++k) {
      const std::size_t before = k > 0 ? k - 1 : k, behind = k + 1 < rows ? k + 1 : k;
      for (int l = 0; l < film_lanes; ++l) {
        const auto row = [&](const std::vector<FilmLanes>& of) {
          return diagonal[k][l] * of[k][l] - below[k][l] * of[before][l] - above[k][l] * of[behind][l];
        };
        EXPECT_NEAR(row(x), first[k][l], 1e-13);
        EXPECT_NEAR(row(y), second[k][l], 1e-13);
      }
    }
  }
}

TEST(MovingSource, under_a_band_and_a_semi_ellipse_of_heat) {
  EXPECT_NEAR(largest_rise([](double x) { return std::abs(x) <= 1.0 ? 1.0 : 0.0; }, 801), 2.0 * std::numbers::sqrt2,
              1e-3 * 2.8284);
  EXPECT_NEAR(largest_rise([](double x) { return std::sqrt(std::max(0.0, 1.0 - x * x)); }, 801), 2.1883, 1e-3 * 2.1883);
}

/// By the discretisation of the reference.
PlacedFilm as_the_reference(double xi, double force_ratio) {
  return {xi, force_ratio, 129, 65, paper_domain(2400.0), Edge::symmetry, FilmDiscretisation::central};
}

TEST(Traction, of_the_case_study_as_the_reference_has_it) {
  const auto& tolerances = friction_case::reference().at("tolerances");
  for (const auto& at : friction_case::reference().at("positions")) {
    const double xi = at.at("xi"), T_0 = 363.15;
    const PlacedFilm placed = as_the_reference(xi, at.at("force").get<double>() / 11908.7);
    const TractionQuantities quantities = traction(heated(), *placed.film).quantities;
    const auto expect = [&](const char* name, double computed, const char* tolerance) {
      const double expected = at.at(name);
      EXPECT_NEAR(computed, expected, tolerances.at(tolerance).get<double>() * std::abs(expected))
          << name << " at " << xi;
    };
    expect("mu", quantities.coefficient, "mu");
    expect("power_sliding", quantities.power_sliding, "power_sliding");
    expect("power_rolling_hpx", quantities.power_rolling, "power_rolling_hpx");
    expect("surface_rise_pinion", quantities.surface_pinion - T_0, "surface_rise");
    expect("surface_rise_wheel", quantities.surface_wheel - T_0, "surface_rise");
    expect("film_mean_rise", quantities.film_mean - T_0, "film_rise");
    expect("film_mid_rise", quantities.film_max - T_0, "film_rise");
    expect("heat_pinion", quantities.heat_pinion, "heat");
    expect("heat_wheel", quantities.heat_wheel, "heat");
    EXPECT_LT(std::abs(quantities.energy_residual), 1e-9);
  }
}

// Where the limit holds everywhere; elsewhere the reference's own is no longer isothermal.
TEST(Traction, of_an_isothermal_film) {
  const PlacedFilm placed(0.0001, 1.0);
  const TractionQuantities quantities = traction({}, *placed.film).quantities;
  for (const auto& at : friction_case::reference().at("positions")) {
    if (at.at("xi") != 0.0001) continue;
    const double expected = at.at("mu_isothermal"), power = at.at("power_isothermal");
    EXPECT_NEAR(quantities.coefficient, expected, 5e-3 * expected);
    EXPECT_NEAR(quantities.power_sliding, power, 5e-3 * power);
  }
}

TEST(Traction, points_across_the_film_converge) {
  const PlacedFilm placed = as_the_reference(0.002, 1.0);
  for (const auto& [points, expected] : friction_case::reference().at("points_across").items()) {
    EXPECT_NEAR(traction(heated(std::stoi(points)), *placed.film).quantities.coefficient, expected.get<double>(),
                2e-3 * expected.get<double>())
        << points;
  }
}

TEST(Traction, pure_rolling_has_no_sliding_friction_and_warms_both_bodies_alike) {
  const PlacedFilm placed(0.0, 1.0);
  for (const TractionModel& model : {TractionModel{}, heated()}) {
    const Traction found = traction(model, *placed.film);
    EXPECT_EQ(found.quantities.sliding_force, 0.0);
    EXPECT_EQ(found.quantities.coefficient, 0.0);
    EXPECT_EQ(found.quantities.power_sliding, 0.0);
    EXPECT_NEAR(found.quantities.heat_pinion, found.quantities.heat_wheel, 1e-9 * found.quantities.heat_wheel);
    for (const double stress : found.fields.shear_stress) EXPECT_EQ(stress, 0.0);
  }
}

TEST(Traction, sliding_backwards_changes_signs_and_bodies_only) {
  const PlacedFilm placed(0.002, 1.0);
  const TractionQuantities one = traction(heated(), *placed.film).quantities;
  ContactConditions backwards = placed.film->conditions();
  backwards.sliding *= -1.0;
  move_surfaces(*placed.film, backwards);
  placed.film->evaluate(placed.result.solution.pressure, placed.result.solution.H0);
  const TractionQuantities other = traction(heated(), *placed.film).quantities;
  EXPECT_NEAR(one.sliding_force, -other.sliding_force, 1e-7 * one.sliding_force);
  EXPECT_NEAR(one.surface_pinion, other.surface_wheel, 1e-5);
  EXPECT_NEAR(one.heat_pinion, other.heat_wheel, 1e-7 * one.heat_pinion);
  EXPECT_DOUBLE_EQ(one.power_rolling, other.power_rolling);
}

TEST(Traction, coulombs_law_gives_its_coefficient) {
  const PlacedFilm placed(0.002, 1.0);
  TractionModel model;
  model.law = {.kind = ShearLawKind::coulomb, .coefficient = 0.05};
  EXPECT_NEAR(traction(model, *placed.film).quantities.coefficient, 0.05, 1e-12);
}

TEST(Traction, of_an_oil_that_does_not_thin_with_heat_or_conducts_it_well_is_isothermal) {
  const PlacedFilm placed(0.005, 0.5);
  const double isothermal = traction({}, *placed.film).quantities.coefficient;
  TractionModel insensitive = heated(), conducting = heated();
  insensitive.heat->oil.temperature_viscosity = 1e-3;
  conducting.heat->oil.conductivity = 1e3;
  for (HeatedBody& body : conducting.bodies) body.conductivity = 1e9;
  for (const TractionModel& model : {insensitive, conducting}) {
    EXPECT_NEAR(traction(model, *placed.film).quantities.coefficient, isothermal, 0.01 * isothermal);
  }
}

/// Int Int h^3 |grad p|^2/(12 eta) with the conductance that Reynolds' equation has at the faces of the cells [W].
double heat_of_flow(const ContactFilm& film) {
  const Grid& grid = film.grid();
  const FilmState& state = film.state();
  std::vector<double> heat(grid.local_size(), 0.0);
  for (int i = 1; i < grid.nx() - 1; ++i) {
    const FlowAlongX<FilmDiscretisation::fitted> before(film.discretisation()->equation(), state, i - 1),
        behind(film.discretisation()->equation(), state, i);
    const StateLine west(state, i - 1), line(state, i), east(state, i + 1);
    for (int j = 0; j < grid.y_count(); ++j) {
      if (grid.is_boundary(i, j)) continue;
      const double along =
          0.5 * (before.driven(j) * (west.p[j] - line.p[j]) + behind.driven(j) * (line.p[j] - east.p[j])) / grid.h_x();
      const double south = flow_along_y<FilmDiscretisation::fitted>(line, j - 1).value * (line.p[j - 1] - line.p[j]);
      const double north = flow_along_y<FilmDiscretisation::fitted>(line, j).value * (line.p[j] - line.p[j + 1]);
      const double across = 0.5 * (south + north) / (line.rho[j] * grid.h_y() * grid.h_y());
      heat[static_cast<std::size_t>(i) * grid.y_count() + j] = along + across;
    }
  }
  // xi_R/rho = H^3/(eta lambda), so that h^3/(12 eta_0 eta) = xi_R/rho lambda (a^2/R_x)^3/(12 eta_0).
  const Scales& scales = film.scales();
  return integral(grid, heat) * scales.lambda * std::pow(scales.thickness, 3) * scales.pressure * scales.pressure /
         (12.0 * scales.oil.viscosity);
}

// Reynolds' equation times Int dp/rho: Int Int u_m h p_x = Int Int h^3 |grad p|^2/(12 eta), all of it heat. Slowly,
// since viscosity falls by decades from node to node where the film ends: 0.82, 0.88, 0.90; 0.94 on 1025 nodes.
TEST(Traction, the_power_lost_by_rolling_is_the_heat_of_the_flow_that_pressure_drives) {
  const FilmCase pitch = table3_pitch();
  double last = 1.0;
  for (const int nx : {65, 129, 257}) {
    const SolvedFilm solved(PETSC_COMM_WORLD, pitch, nx, 65);
    const double rolling = traction({}, solved.film).quantities.power_rolling;
    const double error = std::abs(heat_of_flow(solved.film) / rolling - 1.0);
    report("%d lines: heat over power %.4f", nx, 1.0 - error);
    EXPECT_LT(error, 0.9 * last) << nx;
    last = error;
  }
  EXPECT_LT(last, 0.11);
}

}  // namespace
}  // namespace gearfilm
