// Periodic orbits of the dry and of the lubricated pair, and what their multipliers say.
#include <Eigen/LU>
#include <numbers>

#include "mesh/natural_frequency.hpp"
#include "orbits/floquet.hpp"
#include "orbits/free_decay.hpp"
#include "orbits/periodic_orbit.hpp"
#include "pair_case.hpp"
#include "solver/stationary.hpp"

namespace gearfilm {
namespace {

Settings after_leaving_place() { return {{"start.place", "after_leaving"}, {"time.dt", "0.026"}}; }

double free_frequency_of(const CaseInput& problem, const Monodromy& monodromy) {
  return free_oscillation(multipliers(monodromy), mesh_frequency(*problem.pair.gears, problem.pair.pinion_speed),
                          mesh_of(problem).frequency_si())
      .value()
      .frequency;
}

TEST(Monodromy, multipliers_solve_the_characteristic_equation) {
  const Monodromy rotation{{0.8, -0.5}, {0.6, 0.7}};
  for (const std::complex<double>& mu : multipliers(rotation)) {
    EXPECT_LT(std::abs(mu * mu - 1.5 * mu + (0.8 * 0.7 + 0.5 * 0.6)), 1e-14);
  }
  const auto real = multipliers(Monodromy{{2.0, 0.0}, {0.0, 0.5}});
  EXPECT_DOUBLE_EQ(real[0].real(), 2.0);
  EXPECT_DOUBLE_EQ(real[1].real(), 0.5);
}

TEST(Monodromy, free_oscillation_takes_the_branch_next_to_the_natural_frequency) {
  // 91.8 degrees a mesh period at 7000 Hz: 1785, 5215, 8785 ... Hz; the decay per period is the modulus.
  const double modulus = 0.955, angle = 91.8 * std::numbers::pi / 180.0;
  const Multipliers mu = {std::polar(modulus, angle), std::polar(modulus, -angle)};
  const FreeOscillation oscillation = free_oscillation(mu, 7000.0, 5139.0).value();
  EXPECT_NEAR(oscillation.frequency, 7000.0 * (1.0 - 91.8 / 360.0), 1e-6);
  const double periods_per_cycle = 7000.0 / oscillation.frequency;
  const double decay_per_cycle = -std::log(modulus) * periods_per_cycle;  // 2 pi zeta/sqrt(1-zeta^2)
  EXPECT_NEAR(oscillation.damping_ratio, decay_per_cycle / std::hypot(decay_per_cycle, 2.0 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(free_oscillation(mu, 7000.0, 2000.0)->frequency, 7000.0 * 91.8 / 360.0, 1e-6);
  EXPECT_FALSE(free_oscillation({2.0, 0.5}, 7000.0, 5139.0));
}

TEST(DryOrbit, repeats_and_matches_the_reference) {
  const auto& reference = table3::reference().at("dry_periodic");
  const CaseInput problem = table3_case(after_leaving_place());
  const MeshModel mesh = mesh_of(problem);
  const DryOrbit orbit = find_dry_orbit(mesh, 0.0);
  DryMarch march(mesh, 1.0, [](const StepRecord&, const std::vector<ActiveContact>&) {});
  march.start(orbit.start);
  march.run(mesh.path.mesh_period());
  // Shooting stops at 1e-9, and integrates to 1e-10.
  EXPECT_NEAR(march.motion().H0(), orbit.start.H0(), 1e-8);
  EXPECT_NEAR(march.motion().V0(), orbit.start.V0(), 1e-8);
  EXPECT_NEAR(orbit.largest_integral / problem.scales.static_force, reference.at("force_ratio_max").at("value"),
              reference.at("force_ratio_max").at("abs_tol"));
  EXPECT_NEAR(free_frequency_of(problem, orbit.monodromy), reference.at("free_frequency").at("value"),
              reference.at("free_frequency").at("abs_tol"));
  // Without damping the map keeps areas.
  EXPECT_NEAR(std::abs(multipliers(orbit.monodromy)[0]), 1.0, 1e-5);
}

// The damper alone contracts the plane of motion: det = exp(-2 zeta omega_n T_m order), whatever the orbit.
TEST(DryOrbit, product_of_both_multipliers_is_the_dampers) {
  for (const auto& [order, product] : {std::pair{1, 0.92885}, std::pair{2, 0.86277}, std::pair{4, 0.74437}}) {
    MeshModel mesh = mesh_of(table3_case(after_leaving_place()));
    mesh.order = order;
    const auto mu = multipliers(find_dry_orbit(mesh, 0.008).monodromy);
    EXPECT_NEAR((mu[0] * mu[1]).real(), product, 2e-5) << order;
  }
}

TEST(DryOrbit, damping_leads_over_the_end_of_a_branch) {
  // At 10500 rpm the orbit of the strongly damped pair ends in a fold; the lightly damped one loses contact.
  const CaseInput problem = table3_case(with(after_leaving_place(), {{"pinion.speed_rpm", "10500"}}));
  const MeshModel mesh = mesh_of(problem);
  const DryOrbit orbit = find_dry_orbit(mesh, 0.05);
  EXPECT_GT(orbit.largest_integral / problem.scales.static_force, 2.0);
  EXPECT_LT(std::abs(multipliers(orbit.monodromy)[0]), 1.0);
}

PeriodicOrbit search(RecordedMarch& march, const OrbitGuess& guess) {
  return find_periodic_orbit(march.march(), guess, march.problem().search.options, [](const SearchPeriod& period) {
    report("mesh period %d: defect %.1e, of the films %.1e", period.number, period.defect, period.film_defect);
  });
}

/// The dry orbit, shifted by the stationary film at the pitch point.
OrbitGuess dry_guess_of(const RecordedMarch& march) {
  const CaseInput& problem = march.problem();
  const DryOrbit dry = find_dry_orbit(march.mesh(), typical_film_damping);
  ContactFilm film(discretise(march.grid(), problem), problem.scales, problem.numerics.solver.multigrid);
  const StationaryResult at_pitch =
      solve_stationary(film, LoadCondition::force(problem.scales.static_force), problem.numerics.solver);
  return guess_from(dry, at_pitch.solution.H0 + problem.scales.approach);
}

Settings coarse_orbit() {
  return {{"grid.nx", "65"}, {"grid.ny", "33"}, {"time.dt", "0.05"}, {"start.place", "after_leaving"}};
}

TEST(Orbit, a_bad_guess_recovers) {
  RecordedMarch march(table3_case(with(coarse_orbit(), {{"grid.y_half", "1.4"}, {"grid.x_max", "1.5"}})));
  OrbitGuess guess = dry_guess_of(march);
  guess.motion.H0() += 0.15;
  guess.monodromy = 0.5 * Monodromy::Identity(2, 2);  // nothing like the map
  const PeriodicOrbit orbit = search(march, guess);
  RecordedMarch straight(table3_case(with(coarse_orbit(), {{"grid.y_half", "1.4"}, {"grid.x_max", "1.5"}})));
  const PeriodicOrbit expected = search(straight, dry_guess_of(straight));
  EXPECT_NEAR(orbit.start.motion.H0(), expected.start.motion.H0(), 2e-3);
  EXPECT_NEAR(orbit.start.motion.V0(), expected.start.motion.V0(), 2e-3);
  // From its own end the orbit is found at once, with the films of the neighbour.
  RecordedMarch again(table3_case(with(coarse_orbit(), {{"grid.y_half", "1.4"}, {"grid.x_max", "1.5"}})));
  EXPECT_EQ(search(again, {expected.end.motion, expected.monodromy, expected.end}).periods_used, 1);
}

TEST(Orbit, a_period_and_a_newton_step_improve_a_guess) {
  RecordedMarch march(table3_case(with(coarse_orbit(), {{"grid.y_half", "1.4"}, {"grid.x_max", "1.5"}})));
  const PeriodicOrbit orbit = search(march, dry_guess_of(march));
  const Motion& begin = orbit.end.motion;
  const OrbitGuess guess{{begin.H0() + 0.02, begin.V0() - 0.02}, orbit.monodromy, orbit.end};
  RecordedMarch again(table3_case(with(coarse_orbit(), {{"grid.y_half", "1.4"}, {"grid.x_max", "1.5"}})));
  const OrbitGuess better = improved_guess(again.march(), guess, [](const SearchPeriod&) {});
  EXPECT_LT(length(difference(better.motion, begin)), 0.1 * length(difference(guess.motion, begin)));
  EXPECT_TRUE(better.neighbour);
}

TEST(Orbit, a_search_that_comes_no_nearer_is_given_up) {
  RecordedMarch march(table3_case(with(coarse_orbit(), {{"grid.y_half", "1.4"}, {"grid.x_max", "1.5"}})));
  PeriodicOptions options = march.problem().search.options;
  options.tolerance = options.film_tolerance = 1e-15;  // below the noise of marches
  options.patience = 3;
  int periods = 0;
  const auto count = [&](const SearchPeriod& period) { periods = period.number; };
  EXPECT_THROW(find_periodic_orbit(march.march(), dry_guess_of(march), options, count), NoPeriodicState);
  EXPECT_GT(periods, options.patience);
  EXPECT_LT(periods, options.max_periods);
}

TEST(Orbit, films_that_begin_before_a_period_repeat_sooner) {
  constexpr double lead = 1.0;
  const Settings settings = with(coarse_orbit(), {{"grid.y_half", "1.4"}, {"grid.x_max", "1.5"}});
  RecordedMarch march(table3_case(settings));
  PeriodicOptions options = march.problem().search.options;
  const SearchObserver silent = [](const SearchPeriod&) {};
  options.lead = lead;
  const PeriodicOrbit orbit = find_periodic_orbit(march.march(), dry_guess_of(march), options, silent);
  ASSERT_TRUE(orbit.before);
  const FreeDecay decay = free_decay(march.march(), orbit, {.lead = lead});
  ASSERT_TRUE(decay.lead_map);
  // The motion turns by 0.6 a unit of time, and hardly decays in so short a time.
  const Monodromy& map = *decay.lead_map;
  EXPECT_NEAR(map.determinant(), 1.0, 0.1);
  EXPECT_NEAR(map(0, 1), lead, 0.2);  // dH_0/dT = V_0
  // From a motion that is off, one step leads to the orbit; its films have had the lead to follow.
  OrbitGuess guess{orbit.end.motion, decay.map, orbit.before, lead, decay.lead_map};
  guess.neighbour->motion.H0() += 0.02;
  const auto second_period = [&](const OrbitGuess& from) {
    RecordedMarch again(table3_case(settings));
    SearchPeriod second;
    const PeriodicOrbit found =
        find_periodic_orbit(again.march(), from, again.problem().search.options, [&](const SearchPeriod& period) {
          if (period.number == 2) second = period;
        });
    EXPECT_LT(length(difference(found.start.motion, orbit.start.motion)), 5e-4);
    report("second period: motion %.1e, films %.1e", second.defect, second.film_defect);
    return second;
  };
  const SearchPeriod with_lead = second_period(guess);
  guess.lead_map = {};
  const SearchPeriod at_once = second_period(guess);
  EXPECT_LT(with_lead.film_defect, 0.7 * at_once.film_defect);
  EXPECT_LT(with_lead.defect, 4e-3);
}

TEST(Orbit, too_few_periods_are_an_error_that_names_the_defect) {
  RecordedMarch march(table3_case(with(coarse_orbit(), {{"periodic.max_periods", "1"}})));
  try {
    (void)search(march, dry_guess_of(march));
    FAIL() << "found in one period";
  } catch (const SolveError& error) {
    EXPECT_NE(std::string(error.what()).find("still changes by"), std::string::npos) << error.what();
  }
}

TEST(SlowOrbit, the_lubricated_orbit_is_found_within_six_mesh_periods) {
  const auto& reference = table3::reference().at("film_periodic_129x65_dT_0.026");
  RecordedMarch march(table3_case(after_leaving_place()));
  const PeriodicOrbit orbit = search(march, dry_guess_of(march));
  EXPECT_LE(orbit.periods_used, 4);  // two more for the multipliers
  EXPECT_LT(orbit.defect, 1e-4);
  EXPECT_LT(orbit.film_defect, 1e-3);
  const auto expect = [&](const char* name, double computed) {
    report("%-26s %14.6g", name, computed);
    EXPECT_NEAR(computed, reference.at(name).at("value"), reference.at(name).at("abs_tol")) << name;
  };
  expect("H0_after_leaving", orbit.start.motion.H0());
  expect("V0_after_leaving", orbit.start.motion.V0());
  const CaseInput& problem = march.problem();
  const FloquetMultipliers few = floquet_multipliers(march.march(), orbit, {});
  const FreeOscillation oscillation =
      free_oscillation(few.gear_pair, mesh_frequency(*problem.pair.gears, problem.pair.pinion_speed),
                       mesh_of(problem).frequency_si())
          .value();
  expect("floquet_modulus", std::abs(few.gear_pair[0]));
  expect("free_frequency", oscillation.frequency);
  // More periods change little, and show how small the films' own multipliers are.
  const FloquetMultipliers more = floquet_multipliers(march.march(), orbit, {.periods = 4});
  EXPECT_NEAR(std::abs(more.gear_pair[0]), std::abs(few.gear_pair[0]), 0.005);
  report("films' own below %.1e", more.film_bound.value());
  EXPECT_LT(more.film_bound.value(), 0.02);
}

/// Speeds with an adequate domain, and how many mesh periods their orbit may take.
struct Speed {
  const char* rpm;
  int periods;
  bool loses_contact;
  std::optional<double> modulus{};  ///< of the free oscillation fitted to a long march
};

class SlowOrbitAt : public testing::TestWithParam<Speed> {};

TEST_P(SlowOrbitAt, is_found) {
  const Settings wide = {{"pinion.speed_rpm", GetParam().rpm},
                         {"grid.ny", "81"},
                         {"grid.y_half", "1.5"},
                         {"grid.x_min", "-2.25"},
                         {"grid.x_max", "1.6"}};
  RecordedMarch march(table3_case(with(after_leaving_place(), wide)));
  const PeriodicOrbit orbit = search(march, dry_guess_of(march));
  EXPECT_LE(orbit.periods_used, GetParam().periods);
  EXPECT_LT(orbit.defect, 1e-4);
  EXPECT_LT(orbit.film_defect, 1e-3);
  const double end = orbit.begin + march.path().mesh_period();
  EXPECT_EQ(statistics_of(march).contact_lost(orbit.begin + 1e-6, end), GetParam().loses_contact);
  const FreeDecay decay = free_decay(march.march(), orbit, {});
  const double modulus = std::abs(decay.multipliers[0]);
  report("%s rpm: modulus %.4f +- %.4f, %.2f degrees", GetParam().rpm, modulus, decay.modulus_error(),
         std::arg(decay.multipliers[0]) * 180.0 / std::numbers::pi);
  EXPECT_LT(modulus, 1.0);
  EXPECT_LT(decay.modulus_error(), 0.05);
  if (GetParam().modulus) {
    EXPECT_NEAR(modulus, *GetParam().modulus, 0.005);
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, SlowOrbitAt,
                         testing::Values(Speed{"8000", 4, false}, Speed{"12500", 6, true, 0.953},
                                         Speed{"20000", 4, false}),
                         [](const auto& tested) { return "at_" + std::string(tested.param.rpm) + "_rpm"; });

}  // namespace
}  // namespace gearfilm
