// Natural modes: the dry pair's, and those of the pair on its films against a march that rings down.
#include <cmath>
#include <numbers>

#include "film/face_flow.hpp"
#include "input/case_numerics.hpp"
#include "mesh/natural_frequency.hpp"
#include "mesh/static_mesh.hpp"
#include "orbits/dry_modes.hpp"
#include "orbits/dynamic_stiffness.hpp"
#include "orbits/film_modes.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

TEST(DryModes, one_is_rigid_and_one_has_the_natural_frequency) {
  const CaseInput problem = table3_case();
  const double k_el = mesh_of(problem).stiffness_si();
  const std::array<double, 2> radii = {problem.pair.line->base_radius_pinion(), problem.pair.line->base_radius_wheel()};
  const GearInertias inertias = disc_inertias(radii, *problem.pair.equivalent_mass);
  const auto [rigid, swinging] = dry_modes(k_el, radii, inertias);
  const auto& reference = table3::reference().at("derived").at("f_n");
  EXPECT_NEAR(swinging.frequency, reference.at("value"), 1e-3 * reference.at("value").get<double>());
  EXPECT_NEAR(swinging.frequency, natural_frequency(k_el, *problem.pair.equivalent_mass), 1e-9 * swinging.frequency);
  EXPECT_LT(rigid.frequency, 1e-6 * swinging.frequency);
  // Geared together: R_b1 phi_1 = R_b2 phi_2.
  EXPECT_NEAR(radii[0] * rigid.shape[0], radii[1] * rigid.shape[1], 1e-9 * radii[0]);
  // The contact's force turns both: I_1 phi_1/R_b1 = -I_2 phi_2/R_b2.
  EXPECT_NEAR(inertias.pinion * swinging.shape[0] / radii[0], -inertias.wheel * swinging.shape[1] / radii[1],
              1e-9 * inertias.pinion / radii[0]);
}

// Teeth and contact in series, 1/k = 1/k_el + c_kk(0); reference: another program's.
TEST(DryModes, bending_teeth_are_in_series_with_the_contact) {
  const CaseInput problem = table3_case(bending());
  const double k = mesh_of(problem).stiffness_si();
  EXPECT_NEAR(1.0 / k - 1.0 / mesh_of(table3_case()).stiffness_si(), problem.pair.teeth.compliance(0.0), 1e-15);
  const std::array<double, 2> radii = {problem.pair.line->base_radius_pinion(), problem.pair.line->base_radius_wheel()};
  const auto [rigid, swinging] = dry_modes(k, radii, disc_inertias(radii, *problem.pair.equivalent_mass));
  EXPECT_NEAR(swinging.frequency, 3727.2, 0.002 * 3727.2);
}

// Three contacts at the pitch point swing together.
TEST(DryModes, stiffness_is_that_of_all_contacts_at_the_pitch_point) {
  const CaseInput problem = input_case("high_contact_ratio.yaml");
  const MeshModel mesh = mesh_of(problem);
  const StaticMesh turned = quasi_static_cycle(mesh, mesh.scales.static_force, 50);
  ASSERT_EQ(turned.at_pitch.contacts.size(), 3u);
  EXPECT_NEAR(mesh.stiffness / turned.at_pitch.stiffness, 1.0, 1e-9);
  const double alone = 1.5 * mesh.scales.static_force / mesh.scales.approach;
  EXPECT_GT(mesh.stiffness, 1.9 * alone);  // with three alike 3^(2/3) = 2.08
  EXPECT_NEAR(1.0 / natural_period(problem), natural_frequency(mesh.stiffness, mesh.inertia), 1e-12);
}

TEST(DryModes, pitch_errors_do_not_change_the_stiffness) {
  std::string errors;
  for (int tooth = 0; tooth < 40; ++tooth) errors += tooth % 2 ? " 2e-5" : " 0";
  const CaseInput plain = input_case("high_contact_ratio.yaml");
  const CaseInput rough = input_case("high_contact_ratio.yaml", {{"pinion.pitch_errors", errors}});
  EXPECT_EQ(plain.pair.stiffness, rough.pair.stiffness);
}

TEST(DryModes, very_different_inertias) {
  const std::array<double, 2> radii = {0.04, 0.4};
  const GearInertias inertias = {1e-4, 1e3};
  const double k = 3e8, mass = 1.0 / (radii[0] * radii[0] / inertias.pinion + radii[1] * radii[1] / inertias.wheel);
  const auto [rigid, swinging] = dry_modes(k, radii, inertias);
  EXPECT_NEAR(swinging.frequency, natural_frequency(k, mass), 1e-9 * swinging.frequency);
  EXPECT_LT(rigid.frequency, 1e-6 * swinging.frequency);
}

TEST(DryModes, disc_inertias_have_the_mass) {
  const std::array<double, 2> radii = {0.04, 0.06};
  const GearInertias inertias = disc_inertias(radii, 0.37);
  EXPECT_NEAR(1.0 / (radii[0] * radii[0] / inertias.pinion + radii[1] * radii[1] / inertias.wheel), 0.37, 1e-15);
  EXPECT_NEAR(inertias.wheel / inertias.pinion, std::pow(1.5, 4), 1e-12);
}

/// The pair at rest on its films, on a coarse grid, linearised with all levels of the preconditioner.
class PairAtRest {
public:
  explicit PairAtRest(const Settings& settings)
      : problem_(table3_case(with({{"grid.nx", "65"}, {"grid.ny", "33"}, {"solver.precision", "double"}}, settings))),
        march_(discretise(PETSC_COMM_WORLD, problem_),
               mesh_model(problem_, problem_.march.start_position, MeshGeometry::held),
               {problem_.numerics.solver, problem_.numerics.steps},
               [](const StepRecord&, const std::vector<ActiveContact>&) {}) {
    march_.start({});
    pair_ = std::make_unique<LubricatedPair>(march_.mesh(), march_.contacts());
    state_ = pair_->system().create_state();
    const PairState at_rest = march_.state();
    for (std::size_t k = 0; k < at_rest.films.size(); ++k) {
      pair_->system().set_field(state_, k, values_of(at_rest.films[k], field::pressure));
    }
    pair_->set_motion(state_, at_rest.motion);
  }

  const CaseInput& problem() const { return problem_; }
  const SharedDiscretisation& discretisation() const { return march_.contacts().front().film->discretisation(); }
  const MeshModel& mesh() const { return march_.mesh(); }
  LubricatedPair& pair() { return *pair_; }
  Vec state() { return state_; }
  double H0() const { return march_.motion().H0(); }
  double natural_rate() const { return 2.0 * std::numbers::pi * mesh().frequency(); }

private:
  CaseInput problem_;
  MeshMarch march_;
  std::unique_ptr<LubricatedPair> pair_;
  OwnedVec state_;
};

// The operator at a shift is A + shift B.
TEST(FilmPencil, multiply_grows_linearly_with_the_shift) {
  PairAtRest rest(with(bending(), {{"start.place", "position"}, {"start.position", "4e-3"}}));
  FilmSystem& system = rest.pair().system();
  system.film(0).set_rates_in_wedge(rates_in_wedge(0.0));
  const OwnedVec rows = system.create_state(), change = system.create_state(), still = system.create_state(),
                 moving = system.create_state();
  petsc_check(VecCopy(rest.state(), change));
  rest.pair().linearise(rest.state(), {}, 0.0);
  system.multiply(change, still);
  system.multiply_transient(change, moving);
  constexpr double shift = 7.0;
  rest.pair().linearise(rest.state(), {}, shift);
  system.multiply(change, rows);
  PetscReal size = 0.0, off = 0.0;
  petsc_check(VecNorm(rows, NORM_INFINITY, &size));
  petsc_check(VecAXPY(rows, -1.0, still));
  petsc_check(VecAXPY(rows, -shift, moving));
  petsc_check(VecNorm(rows, NORM_INFINITY, &off));
  EXPECT_LT(off, 1e-12 * size);
}

/// lambda of x ~ exp(lambda T) from a free oscillation: least squares of x_(n+1) = a x_n + b x_(n-1) + c on uniform
/// samples, whose characteristic roots are exp(lambda step).
std::complex<double> fitted_eigenvalue(const std::vector<double>& x, double step) {
  double normal[3][4] = {};
  for (std::size_t n = 1; n + 1 < x.size(); ++n) {
    const double row[4] = {x[n], x[n - 1], 1.0, x[n + 1]};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) normal[i][j] += row[i] * row[j];
    }
  }
  for (int pivot = 0; pivot < 3; ++pivot) {
    for (int i = 0; i < 3; ++i) {
      if (i == pivot) continue;
      const double factor = normal[i][pivot] / normal[pivot][pivot];
      for (int j = pivot; j < 4; ++j) normal[i][j] -= factor * normal[pivot][j];
    }
  }
  const double a = normal[0][3] / normal[0][0], b = normal[1][3] / normal[1][1];
  const std::complex<double> root = 0.5 * a + std::sqrt(std::complex<double>(0.25 * a * a + b));
  return std::log(root) / step;
}

/// A pair, and the march in which it rings down: at low speed it swings often while oil crosses the contact.
struct RingDown {
  const char* name;
  Settings settings;
  double dT, begin, end;  ///< begin: when the films have followed
  int stride;             ///< steps between the samples that are fitted: neighbours hardly differ
};

std::ostream& operator<<(std::ostream& out, const RingDown& tested) { return out << tested.name; }

class SwingingMode : public testing::TestWithParam<RingDown> {};

// Geometry held at the pitch point, H_0 released a little off balance.
TEST_P(SwingingMode, agrees_with_a_march_that_rings_down) {
  const RingDown& tested = GetParam();
  PairAtRest rest(tested.settings);
  const std::complex<double> mode = swinging_mode(rest.pair(), rest.state()).rate;
  const CaseInput& problem = rest.problem();
  std::vector<double> samples;
  StepOptions steps = problem.numerics.steps;
  steps.dT = tested.dT;
  MeshMarch march(rest.discretisation(), rest.mesh(), {problem.numerics.solver, steps},
                  [&](const StepRecord& record, const std::vector<ActiveContact>&) {
                    if (record.T > tested.begin) samples.push_back(record.motion.H0());
                  });
  march.start(Motion{rest.H0() + 2e-3, 0.0});
  march.run(tested.end);
  std::vector<double> sparse;
  for (std::size_t n = 0; n < samples.size(); n += tested.stride) sparse.push_back(samples[n] - rest.H0());
  const std::complex<double> rung = fitted_eigenvalue(sparse, tested.stride * tested.dT);
  report("eigenvalue %.6f %+.6fi, ring-down %.6f %+.6fi", mode.real(), mode.imag(), rung.real(), rung.imag());
  EXPECT_NEAR(mode.imag(), std::abs(rung.imag()), 0.01 * std::abs(rung.imag()));
  EXPECT_NEAR(mode.real(), rung.real(), 0.1 * std::abs(rung.real()));
  EXPECT_LT(mode.real(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    speeds, SwingingMode,
    testing::Values(RingDown{"fast", {}, 0.05, 2.0, 25.0, 8},
                    RingDown{"on_two_bending_teeth",
                             with(bending(), {{"start.place", "position"}, {"start.position", "4e-3"}}), 0.05, 2.0,
                             25.0, 8},
                    RingDown{"slow",
                             {{"pinion.speed_rpm", "3000"}, {"pinion.torque", "100"}, {"lubricant.viscosity", "0.2"}},
                             0.0125,
                             2.0,
                             8.0,
                             8}),
    [](const auto& tested) { return tested.param.name; });

// Where oil crosses the contact slowly the films' own modes are nearer to zero than the pair's.
TEST(SwingingMode, is_that_of_the_pair_among_those_of_the_films) {
  for (const char* speed : {"50", "15000"}) {
    PairAtRest rest({{"pinion.speed_rpm", speed}, {"pinion.torque", "5"}, {"lubricant.viscosity", "0.5"}});
    const std::complex<double> mode = swinging_mode(rest.pair(), rest.state()).rate;
    report("%s rpm: %.5f %+.5fi, dry %.5fi", speed, mode.real(), mode.imag(), rest.natural_rate());
    EXPECT_NEAR(mode.imag(), rest.natural_rate(), 0.25 * rest.natural_rate());
    EXPECT_LT(mode.real(), 0.0);
  }
}

// SLEPc solves the same problem for all eigenvalues at once.
TEST(SwingingMode, is_an_eigenvalue_of_the_whole_system) {
  PairAtRest rest(with(bending(), {{"start.place", "position"}, {"start.position", "4e-3"}}));
  ASSERT_EQ(rest.pair().numbers().size(), 2u);
  const std::complex<double> mode = swinging_mode(rest.pair(), rest.state()).rate;
  double nearest = HUGE_VAL;
  for (const FilmMode& other : film_modes(rest.pair(), rest.state(), {})) {
    nearest = std::min(nearest, std::abs(other.eigenvalue - mode));
  }
  EXPECT_LT(nearest, 1e-7 * std::abs(mode));
}

TEST(SwingingMode, of_two_contacts_is_faster) {
  PairAtRest one({}), two({{"start.place", "position"}, {"start.position", "4e-3"}});
  ASSERT_EQ(two.pair().numbers().size(), 2u);
  const std::complex<double> single = swinging_mode(one.pair(), one.state()).rate;
  const std::complex<double> both = swinging_mode(two.pair(), two.state()).rate;
  // Two Hertz contacts with half the force each: stiffer by 2 (1/2)^(1/3), so faster by its root, 1.26.
  EXPECT_NEAR(both.imag() / single.imag(), std::sqrt(2.0 * std::cbrt(0.5)), 0.05);
}

}  // namespace
}  // namespace gearfilm
