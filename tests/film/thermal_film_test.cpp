// Films that feel their heat: the flow in a film of uneven viscosity against closed integrals, the corrected Jacobian,
// and the case study against an independent program.
#include <gtest/gtest.h>

#include "friction_reference.hpp"
#include "placed_film.hpp"
#include "traction/coupled_film.hpp"
#include "traction/film_flow.hpp"

namespace gearfilm {
namespace {

constexpr double viscosity = 0.04, film_height = 1e-6;

/// The flow in a film whose fluidity is f(z/h) times that at T_0, with u_s = 2 m/s and q_P/h = q [m/s].
struct KnownFlow {
  template <class Fluidity>
  KnownFlow(Fluidity f, double q, int points) : flow(weights_of(points), places_of(points)) {
    using Lanes = FilmLanes;
    const auto all = [](double value) {
      Lanes lanes;
      lanes.fill(value);
      return lanes;
    };
    std::vector<Lanes> fluidity, slope, log_viscosity;
    double mean = 0.0;
    for (int k = 0; k < points; ++k) {
      fluidity.push_back(all(f(places_of(points)[k])));
      slope.push_back(all(-0.04));
      log_viscosity.push_back(all(-std::log(f(places_of(points)[k]))));
      mean += weights_of(points)[k] * fluidity.back()[0];
    }
    std::vector<Lanes> share = fluidity;
    for (Lanes& lanes : share) lanes = all(lanes[0] / mean);
    flow.update({fluidity, slope, log_viscosity, share},
                {all(1.0), all(film_height), all(0.0), all(q), all(q), all(stress), all(1.0), viscosity, all(sliding)});
  }

  static std::vector<double> places_of(int points) {
    std::vector<double> places;
    for (int k = 0; k < points; ++k) places.push_back(k / (points - 1.0));
    return places;
  }
  static std::vector<double> weights_of(int points) {
    std::vector<double> weights(points, 1.0 / (points - 1));
    weights.front() *= 0.5;
    weights.back() *= 0.5;
    return weights;
  }
  double mean(const std::vector<FilmLanes>& values) const {
    const std::vector<double> weights = weights_of(static_cast<int>(values.size()));
    double sum = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) sum += weights[k] * values[k][0];
    return sum;
  }

  static constexpr double sliding = 2.0, stress = 1e6;
  OwnFlow flow;
};

TEST(OwnFlow, of_even_viscosity_is_that_of_reynolds_equation) {
  for (const double q : {-3.0, 0.5}) {
    const KnownFlow known([](double) { return 1.0; }, q, 17);
    EXPECT_NEAR(known.flow.log_factor[0], 0.0, 1e-14);
    EXPECT_NEAR(known.flow.centre[0], 0.5, 1e-14);
    EXPECT_NEAR(known.mean(known.flow.poiseuille), q, 5e-3 * std::abs(q));  // 17 points
    // 12 eta q_P^2/h^3 over the film.
    const double heat = 12.0 * viscosity * q * q / (film_height * film_height);
    EXPECT_NEAR(known.mean(known.flow.heat), heat, 1e-12 * heat);
  }
}

// f = 1 + c z: J_0 = 1 + c/2, J_1 = 1/2 + c/3, J_2 = 1/3 + c/4.
TEST(OwnFlow, of_viscosity_that_falls_towards_one_wall) {
  for (const double c : {1.0, 30.0}) {
    const double J_0 = 1.0 + c / 2.0, J_1 = 0.5 + c / 3.0, J_2 = 1.0 / 3.0 + c / 4.0;
    const double factor = 12.0 * (J_2 - J_1 * J_1 / J_0), q = -2.0;
    const KnownFlow known([c](double z) { return 1.0 + c * z; }, q, 257);
    EXPECT_NEAR(known.flow.log_factor[0], std::log(factor), 1e-4);
    EXPECT_NEAR(known.flow.centre[0], J_1 / J_0, 1e-5);
    EXPECT_NEAR(known.mean(known.flow.poiseuille), q, 1e-10);
    EXPECT_NEAR(known.flow.poiseuille.back()[0], 0.0, 1e-10);
    // Its mean does not have the heat that stress and gradient make together.
    const double heat = 12.0 * viscosity * q * q / (film_height * film_height * factor);
    EXPECT_NEAR(known.mean(known.flow.heat), heat, 1e-4 * heat);
  }
}

TractionModel coupled(TractionModel model) {
  model.heat->couple_film = true;
  return model;
}

/// The thermal film at a place.
struct HotFilm : PlacedFilm {
  HotFilm(double xi, int nx, int ny, const TractionModel& model = heated(), Domain domain = wide,
          Edge lower = Edge::symmetry, FilmDiscretisation by = FilmDiscretisation::fitted)
      : PlacedFilm(xi, 1.0, nx, ny, domain, lower, by),
        thermal(solve_coupled(*film, load, SolverOptions{}, coupled(model), result)) {}

  double factor() const { return thermal.film.quantities.central_film / result.quantities.central_film; }

  static constexpr Domain wide{-4.5, 1.5, 1.2};
  CoupledFilm thermal;
};

// The reference marches along x in steps of first order: on the same grid its films are 2 to 3 % thicker, on twice as
// many lines 1.7 %. One per cent is added to its tolerances.
TEST(ThermalFilm, of_the_case_study_as_the_reference_has_it) {
  const auto& reference = friction_case::reference().at("thermal_film");
  const auto& tolerances = reference.at("tolerances");
  for (const auto& at : reference.at("positions")) {
    if (at.at("grid") != "257 x 65") continue;
    const double xi = at.at("xi");
    const HotFilm hot(xi, 257, 65, heated(), HotFilm::wide, Edge::symmetry, FilmDiscretisation::central);
    const TractionQuantities& quantities = hot.thermal.traction.quantities;
    const double thickness = hot.film->scales().thickness, T_0 = 363.15;
    const auto expect = [&](const char* name, double computed, const char* tolerance) {
      const double expected = at.at(name);
      EXPECT_NEAR(computed, expected, (0.01 + tolerances.at(tolerance).get<double>()) * std::abs(expected))
          << name << " at " << xi;
    };
    expect("h_central", thickness * hot.thermal.film.quantities.central_film, "h_central");
    expect("h_min", thickness * hot.thermal.film.quantities.smallest_film, "h_min");
    expect("thermal_factor", hot.factor(), "thermal_factor");
    expect("power_rolling_hpx", quantities.power_rolling, "power_rolling_hpx");
    if (xi != 0.0) {
      expect("mu", quantities.coefficient, "mu");
      expect("power_sliding", quantities.power_sliding, "power_sliding");
      expect("surface_rise_pinion", quantities.surface_pinion - T_0, "surface_rise");
      expect("surface_rise_wheel", quantities.surface_wheel - T_0, "surface_rise");
      expect("heat_pinion", quantities.heat_pinion, "heat");
      expect("heat_wheel", quantities.heat_wheel, "heat");
    }
    EXPECT_LT(std::abs(quantities.energy_residual), 1e-8);
    EXPECT_LT(hot.thermal.change, 1e-3);
  }
}

TEST(ThermalFilm, of_oil_that_heat_does_not_thin_is_isothermal) {
  TractionModel insensitive = heated();
  insensitive.heat->oil.temperature_viscosity = 1e-5;
  const HotFilm hot(0.002, 65, 33, insensitive, paper_domain(2400.0));
  EXPECT_NEAR(hot.factor(), 1.0, 1e-3);
}

TEST(ThermalFilm, in_pure_rolling_has_no_sliding_friction_and_warms_both_bodies_alike) {
  const HotFilm hot(0.0, 65, 33, heated(), paper_domain(2400.0));
  EXPECT_EQ(hot.thermal.traction.quantities.sliding_force, 0.0);
  EXPECT_NEAR(hot.thermal.traction.quantities.heat_pinion, hot.thermal.traction.quantities.heat_wheel,
              1e-9 * hot.thermal.traction.quantities.heat_wheel);
}

// The same mass passes the middle, where it is hottest.
TEST(ThermalFilm, that_expands_is_thicker) {
  TractionModel expanding = heated();
  expanding.heat->oil.expansion = 7e-4;
  const Domain narrow = paper_domain(2400.0);
  const HotFilm rigid(0.002, 65, 33, heated(), narrow), hot(0.002, 65, 33, expanding, narrow);
  EXPECT_GT(hot.factor(), 1.05 * rigid.factor());
  EXPECT_LT(hot.factor(), 1.25 * rigid.factor());
}

TEST(ThermalFilm, on_all_rows_is_that_on_half_of_them) {
  const Domain narrow = paper_domain(2400.0);
  // Central: its turns go the same way whatever the last digits, and settle alike.
  constexpr FilmDiscretisation by = FilmDiscretisation::central;
  const HotFilm half(0.002, 65, 33, heated(), narrow, Edge::symmetry, by),
      all(0.002, 65, 33, heated(), narrow, Edge::ambient, by);
  const auto same = [&](const std::vector<double>& computed, const std::vector<double>& expected) {
    // The turns between film and heat end at a change of 1e-4.
    expect_whole_is_half(all.grid, whole_of(all.grid, computed), half.grid, whole_of(half.grid, expected), 1e-4);
  };
  same(all.thermal.film.solution.pressure, half.thermal.film.solution.pressure);
  same(all.thermal.traction.fields.temperature_mean, half.thermal.traction.fields.temperature_mean);
  same(all.thermal.traction.fields.shear_stress, half.thermal.traction.fields.shear_stress);
  const TractionQuantities &whole = all.thermal.traction.quantities, &mirrored = half.thermal.traction.quantities;
  EXPECT_NEAR(whole.sliding_force, mirrored.sliding_force, 1e-5 * std::abs(mirrored.sliding_force));
  EXPECT_NEAR(whole.heat_oil, mirrored.heat_oil, 1e-4 * std::abs(mirrored.heat_oil));
  EXPECT_EQ(all.thermal.turns, half.thermal.turns);
}

TEST(ThermalFilm, jacobian_knows_the_correction) {
  TractionModel expanding = heated();
  expanding.heat->oil.expansion = 7e-4;
  const HotFilm hot(0.005, 129, 33, expanding, paper_domain(2400.0));
  expect_second_order(*hot.film, hot.thermal.film.solution);
}

}  // namespace
}  // namespace gearfilm
