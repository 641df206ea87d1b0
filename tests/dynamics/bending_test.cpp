// Films on teeth that bend.
#include <algorithm>
#include <cmath>

#include "dynamics/lubricated_pair.hpp"
#include "mesh/reverse_flanks.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

const std::vector<double>& pressure(const PairState& state, std::size_t contact) {
  return values_of(state.films[contact], field::pressure);
}

/// Two contacts.
Settings shortly_after_an_entry() {
  return with(after_leaving(), {{"start.place", "position"}, {"start.position", "4.5e-3"}, {"start.H0", "-2.2"}});
}

Settings at_rest(Settings settings) {
  settings.erase("start.H0");
  settings.erase("start.V0");
  return settings;
}

// Material that is missing everywhere is met by bodies that are as much nearer.
TEST(BendingFilms, a_gap_everywhere_shifts_the_motion_and_nothing_else) {
  constexpr double gap = 20e-6;
  std::string errors = "-20e-6";
  for (int tooth = 1; tooth < 28; ++tooth) errors += ",-20e-6";
  const Settings common = with(shortly_after_an_entry(), bending());
  RecordedMarch without(table3_case(common));
  const double shift = gap / without.problem().scales.thickness;
  const double H0 = without.problem().march.start_motion->H0() - shift;
  RecordedMarch shifted(table3_case(with(common, {{"pinion.pitch_errors", errors}, {"start.H0", std::to_string(H0)}})));
  for (RecordedMarch* march : {&without, &shifted}) {
    march->start();
    march->run(0.3);
  }
  const PairState a = without.march().state(), b = shifted.march().state();
  EXPECT_NEAR(b.motion.H0(), a.motion.H0() - shift, 2e-6);
  EXPECT_NEAR(b.motion.V0(), a.motion.V0(), 2e-6);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(largest_difference(pressure(a, k), pressure(b, k)), 2e-5);
}

// What a film is displaced by is what it knows of the solids.
TEST(BendingFilms, at_rest_carry_the_static_force_each_at_its_own_displacement) {
  RecordedMarch march(table3_case(with(at_rest(shortly_after_an_entry()), bending())));
  march.start();
  const std::vector<ActiveContact>& contacts = march.march().contacts();
  ASSERT_EQ(contacts.size(), 2u);
  const std::vector<int> numbers = {contacts[0].number, contacts[1].number};
  const PairState state = march.march().state();
  std::vector<double> forces;
  for (std::size_t k = 0; k < 2; ++k) forces.push_back(integral(march.grid(), pressure(state, k)));
  EXPECT_NEAR((forces[0] + forces[1]) / march.static_force(), 1.0, 1e-6);
  EXPECT_GT(*std::ranges::min_element(forces), 0.2 * march.static_force());
  const Compliance compliance = march.mesh().compliance(numbers, 0.0);
  for (std::size_t k = 0; k < 2; ++k) {
    const double displaced = state.motion.H0() + compliance(k, 0) * forces[0] + compliance(k, 1) * forces[1];
    ContactFilm film(march.discretisation(), march.problem().scales, march.problem().numerics.solver.multigrid);
    move_surfaces(film, march.mesh().contact(numbers[k], 0.0).conditions);
    const StationaryResult alone =
        solve_stationary(film, LoadCondition::displacement(displaced), march.problem().numerics.solver);
    EXPECT_NEAR(alone.quantities.pressure_integral, forces[k], 1e-5 * forces[k]);
  }
}

// Under a given force the film does not know what it stands on.
TEST(BendingFilms, quasi_static_fields_do_not_depend_on_the_teeth) {
  const Settings common = {{"model", "quasistatic"},   {"grid.nx", "65"},          {"grid.ny", "33"},
                           {"time.dt", "0.1"},         {"start.position", "1e-3"}, {"load_sharing.kind", "trapezoid"},
                           {"start.place", "position"}};
  RecordedMarch rigid(table3_case(common)), bent(table3_case(with(common, bending())));
  for (RecordedMarch* march : {&rigid, &bent}) {
    march->start();
    march->run(0.5);
  }
  const PairState a = rigid.march().state(), b = bent.march().state();
  EXPECT_LT(largest_difference(pressure(a, 0), pressure(b, 0)), 1e-5);
  const double force = integral(bent.grid(), pressure(b, 0));
  const int number = bent.march().contacts().front().number;
  const double c = bent.mesh().compliance(std::vector{number}, bent.march().T())(0, 0);
  EXPECT_NEAR(b.motion.H0(), a.motion.H0() - c * force, 1e-5);
  EXPECT_GT(c * force, 0.3);
}

// The mesh turned so slowly that nothing swings, and films as thin as they are at 15000 rpm: the shares and the shape
// of the transmission error are those of the dry pair.
TEST(BendingFilms, turned_without_inertia_follow_the_dry_pair) {
  CaseInput problem = table3_case(with(with(at_rest(after_leaving()), with(bending(), relieved())),
                                       {{"pinion.speed_rpm", "5000"}, {"time.dt", "0.1"}}));
  MeshModel mesh = mesh_of(problem);
  mesh.inertia = 0.0;
  std::vector<StepRecord> records;
  MeshMarch march(discretise(PETSC_COMM_WORLD, problem), mesh,
                  {problem.numerics.solver, problem.numerics.steps, {}, {}},
                  [&](const StepRecord& record, const std::vector<ActiveContact>&) { records.push_back(record); });
  march.start({});
  march.run(mesh.path.mesh_period());
  const DryForce dry(mesh);
  const double shift = records.front().motion.H0() -
                       DryContacts(dry, mesh, mesh.path.contacts_after(0.0), 0.0).balance(mesh.scales.static_force);
  int both = 0;
  for (const StepRecord& record : records) {
    std::vector<int> numbers;
    double sum = 0.0;
    for (const ContactRecord& contact : record.contacts) {
      numbers.push_back(contact.number);
      sum += film_quantities(contact.quantities).pressure_integral;
    }
    // A contact that has just entered carries before the motion knows.
    const bool passes = record.T < mesh.path.last_event(record.T) + part_of_transfer * mesh.path.mesh_period();
    EXPECT_NEAR(sum / mesh.scales.static_force, 1.0, passes ? 2e-3 : 1e-5) << record.T;
    const DryContacts contacts(dry, mesh, numbers, record.T);
    const double H0 = contacts.balance(mesh.scales.static_force);
    const std::vector<double> forces = contacts.forces(H0);
    EXPECT_NEAR(record.motion.H0() - shift, H0, 0.04) << record.T;  // 1.1 um of 75; the films are 1.1 um thick
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      EXPECT_NEAR(film_quantities(record.contacts[k].quantities).pressure_integral / mesh.scales.static_force,
                  forces[k] / mesh.scales.static_force, 0.02)
          << record.T;
    }
    if (numbers.size() == 2) ++both;
  }
  EXPECT_GE(both, 10);
}

// A contact leaves under load: the bodies spring back by many films, and the other contact takes that up as a dry one
// would, not with its film.
TEST(BendingFilms, a_film_is_pressed_and_not_crushed_when_its_neighbour_leaves) {
  RecordedMarch march(table3_case(
      with(with(at_rest(after_leaving()), bending()), {{"start.place", "position"}, {"start.position", "5.4e-3"}})));
  march.start();
  march.run(march.path().next_event(0.0) + 1e-6);
  const std::vector<StepRecord>& records = march.records();
  const auto alone =
      std::ranges::find_if(records, [](const StepRecord& record) { return record.contacts.size() == 1; });
  ASSERT_NE(alone, records.end());
  const StepRecord& before = *std::prev(alone);
  const FilmQuantities gone = film_quantities(before.contacts[0].quantities),
                       old = film_quantities(before.contacts[1].quantities),
                       now = film_quantities(alone->contacts[0].quantities);
  const std::vector<int> numbers = {before.contacts[0].number, before.contacts[1].number};
  const double back = march.mesh().compliance(numbers, before.T)(0, 1) * gone.pressure_integral;
  EXPECT_GT(back, 2.0 * old.central_film);
  EXPECT_NEAR(now.central_film, old.central_film, 0.05 * old.central_film);
  const DryContacts both(DryForce(march.mesh()), march.mesh(), numbers, before.T),
      single(DryForce(march.mesh()), march.mesh(), {numbers[1]}, before.T);
  const double H0 = both.balance(gone.pressure_integral + old.pressure_integral);
  const double expected = single.total_force(H0) - both.forces(H0)[1];
  report("springs back by %.3f, force + %.3f, dry + %.3f", back, now.pressure_integral - old.pressure_integral,
         expected);
  EXPECT_NEAR(now.pressure_integral - old.pressure_integral, expected, 0.2 * expected);
  EXPECT_EQ(alone->motion.H0(), before.motion.H0());
}

// sigma and chi of a parabolic relief shift and narrow the contact: R = 1/(1/R_x + chi), x_0 = -sigma R.
TEST(FlanksAsAField, have_their_nearest_point_and_its_radius) {
  const CaseInput problem = table3_case(
      {{"pinion.tip_relief", "20e-6"}, {"pinion.tip_relief_length", "9e-3"}, {"gear.profile_local", "field"}});
  const MeshModel mesh = mesh_of(problem);
  const LineOfAction& line = mesh.path.line();
  const double xi = 3e-3, rho = line.radius_pinion(xi), rate = line.base_radius_pinion() / rho;
  const double into = rho - (line.radius_pinion(line.exit()) - 9e-3), unit = 20e-6 / (9e-3 * 9e-3);
  const double sigma = -2.0 * unit * into * rate, chi = 2.0 * unit * rate * rate;
  const double R = 1.0 / (1.0 / line.radius_x(xi) + chi);
  const ContactConditions conditions = mesh.contact_at(0, xi).conditions;
  EXPECT_NEAR(conditions.dry_radius() * mesh.scales.solids.radius_x / R, 1.0, 0.01);
  EXPECT_NEAR(conditions.nearest.X * mesh.scales.length, -sigma * R, 0.06 * mesh.scales.length);
  EXPECT_NEAR(conditions.nearest.drop * mesh.scales.thickness, 0.5 * sigma * sigma * R, 0.05e-6);
  EXPECT_GT(conditions.nearest.drop, 0.0);
  const DryForce dry(mesh);
  EXPECT_NEAR(dry.law(conditions).force(1.0, 0.0) / force_at_unit_approach(mesh.scales, conditions), 1.0, 1e-9);
}

// Their force is the derivative's, begins at the backlash, and the films' rows know it.
TEST(BackFlanks, push_the_motion_back) {
  RecordedMarch march(table3_case(
      with(shortly_after_an_entry(), {{"gear.backlash", "20e-6"}, {"start.H0", "0.9"}, {"start.V0", "0"}})));
  march.start();
  const double jbar = 20e-6 / march.problem().scales.thickness;
  EXPECT_EQ(reverse_flank_force(march.mesh(), jbar - 1e-9, 0.0).value, 0.0);
  const double step = 1e-6, H0 = march.motion().H0();
  const ReverseForce here = reverse_flank_force(march.mesh(), H0, 0.0);
  const double slope = (reverse_flank_force(march.mesh(), H0 + step, 0.0).value -
                        reverse_flank_force(march.mesh(), H0 - step, 0.0).value) /
                       (2.0 * step);
  EXPECT_GT(here.value, 0.0);
  EXPECT_NEAR(here.slope / slope, 1.0, 1e-6);
  // I_n dV_0/dT = -F_b - F*: the films are far apart.
  march.run(0.02);
  const double rate = march.motion().V0() / 0.02;
  EXPECT_NEAR(march.mesh().inertia * rate, -here.value - march.static_force(), 0.02 * march.static_force());
  LubricatedPair pair(march.mesh(), march.march().contacts());
  pair.place(0.0);
  FilmSystem& system = pair.system();
  const OwnedVec state = system.create_state(), rows = system.create_state(), change = system.create_state();
  pair.set_motion(state, {H0, 0.0});
  pair.linearise(state, {}, 0.0);
  pair.set_motion(change, {1.0, 0.0});
  system.multiply(change, rows);
  EXPECT_NEAR(pair.motion(rows).V0() / system.weight(), here.slope / march.static_force(),
              1e-9 * here.slope / march.static_force());
}

}  // namespace
}  // namespace gearfilm
