// One contact along the whole line of action with a prescribed share of the static force, with and without inertia.
#include <algorithm>
#include <cmath>

#include "pair_case.hpp"
#include "solver/stationary.hpp"

namespace gearfilm {
namespace {

/// Table 3 on a coarse grid, from entry to exit.
class SingleContact {
public:
  SingleContact(const std::string& model, const std::string& sharing, const std::string& dT = "0.05",
                const std::string& jump_time = "0.025")
      : problem_(table3_case({{"grid.nx", "65"},
                              {"grid.ny", "33"},
                              {"grid.y_half", "1.4"},
                              {"time.dt", dT},
                              {"model", model},
                              {"load_sharing.kind", sharing},
                              {"load_sharing.jump_time", jump_time}})),
        discretisation_(discretise(PETSC_COMM_WORLD, problem_)),
        march_(discretisation_, mesh_model(problem_, problem_.march.start_position, problem_.march.geometry),
               {problem_.numerics.solver, problem_.numerics.steps},
               [this](const StepRecord& record, const std::vector<ActiveContact>&) { records_.push_back(record); }) {
    march_.start({});
    march_.run(path().exit_time(0));
  }

  const CaseInput& problem() const { return problem_; }
  const Grid& grid() const { return discretisation_->grid(); }
  const MeshModel& mesh() const { return march_.mesh(); }
  const ContactPath& path() const { return mesh().path; }
  const LoadSharing& sharing() const { return problem_.march.load->sharing; }
  const std::vector<StepRecord>& records() const { return records_; }

private:
  CaseInput problem_;
  SharedDiscretisation discretisation_;
  std::vector<StepRecord> records_;
  MeshMarch march_;
};

class QuasiStatic : public testing::TestWithParam<const char*> {};

TEST_P(QuasiStatic, force_is_the_prescribed_share_at_every_step) {
  const SingleContact contact("quasistatic", GetParam());
  const double F = contact.problem().scales.static_force;
  int steps = 0;
  for (const StepRecord& record : contact.records()) {
    ASSERT_LE(record.contacts.size(), 1u);
    if (record.contacts.empty() || record.dT == 0.0) continue;
    const double xi = record.contacts.front().position;
    EXPECT_NEAR(record.pressure_integral(), contact.sharing()(xi) * F, 1e-5 * F) << xi;
    ++steps;
  }
  EXPECT_GT(steps, 150);
  EXPECT_NEAR(contact.records().back().T, contact.path().exit_time(0), 1e-9);
}

// What the paper states of its own quasi-static model.
TEST_P(QuasiStatic, films_away_from_jumps_are_nearly_the_stationary_ones) {
  const SingleContact contact("quasistatic", GetParam());
  const Scales& scales = contact.problem().scales;
  ContactFilm film(discretise(contact.grid(), contact.problem()), scales, contact.problem().numerics.solver.multigrid);
  int compared = 0;
  for (double wanted : {-0.5e-3, 1.0e-3, 2.5e-3}) {
    const StepRecord& record = *std::min_element(
        contact.records().begin(), contact.records().end(), [&](const StepRecord& a, const StepRecord& b) {
          const auto off = [&](const StepRecord& r) {
            return r.contacts.empty() ? HUGE_VAL : std::abs(r.contacts.front().position - wanted);
          };
          return off(a) < off(b);
        });
    const ContactQuantities& marched = record.contacts.front().quantities;
    move_surfaces(film, contact.mesh().contact(0, record.T).conditions);
    const StationaryResult still = solve_stationary(
        film, LoadCondition::force(contact.sharing()(record.contacts.front().position) * scales.static_force),
        contact.problem().numerics.solver);
    report("xi = %.3f mm: central film %.5f, stationary %.5f", 1e3 * record.contacts.front().position,
           marched["h_central"], still.quantities.central_film);
    EXPECT_NEAR(marched["h_central"], still.quantities.central_film, 0.01 * still.quantities.central_film);
    EXPECT_NEAR(marched["p_central"], still.quantities.central_pressure, 0.01 * still.quantities.central_pressure);
    ++compared;
  }
  EXPECT_EQ(compared, 3);
}

INSTANTIATE_TEST_SUITE_P(Sharing, QuasiStatic, testing::Values("step", "trapezoid"),
                         [](const auto& tested) { return std::string(tested.param); });

// Where the load doubles, oil beside the contact is caught in it and travels through it under a pressure of its own.
// How much depends on the model and neither on the time step nor, once that is short, on the time that the jump takes.
TEST(LoadJump, catches_oil_whatever_the_steps) {
  const auto greatest = [](const SingleContact& contact) {
    double film = 0.0;
    for (const StepRecord& record : contact.records()) {
      if (record.contacts.empty() || std::abs(record.contacts.front().position) > 2.9e-3) continue;
      film = std::max(film, record.contacts.front().quantities["h_central"]);
    }
    return film;
  };
  const SingleContact usual("quasistatic", "step");
  const double film = greatest(usual), finer = greatest({"quasistatic", "step", "0.025"}),
               faster = greatest({"quasistatic", "step", "0.05", "0.00625"});
  report("greatest central film %.4f, with half the steps %.4f, in a quarter of the time %.4f", film, finer, faster);
  EXPECT_GT(film, 1.4 * usual.records().front().contacts.front().quantities["h_central"]);
  EXPECT_NEAR(finer, film, 0.05 * film);
  EXPECT_NEAR(faster, film, 0.05 * film);
}

// I_n (V_0 at the end - V_0 at the start) = Int (F/f - F*) dT.
TEST(SimplifiedDynamic, momentum_is_the_integral_of_the_excess_force) {
  const SingleContact contact("simplified", "trapezoid");
  const double F = contact.problem().scales.static_force;
  double impulse = 0.0, swing = 0.0;
  const std::vector<StepRecord>& records = contact.records();
  const auto excess = [&](const StepRecord& record, const LoadSharing::Piece& piece) {
    return record.pressure_integral() / piece(record.contacts.front().position) - F;
  };
  std::size_t last = 0;
  for (std::size_t n = 1; n < records.size() && !records[n].contacts.empty(); ++n) {
    const LoadSharing::Piece& piece = contact.sharing().piece_at(
        0.5 * (records[n].contacts.front().position + records[n - 1].contacts.front().position));
    impulse += 0.5 * (records[n].T - records[n - 1].T) * (excess(records[n], piece) + excess(records[n - 1], piece));
    swing = std::max(swing, std::abs(records[n].motion.V0()));
    last = n;
  }
  EXPECT_NEAR(contact.mesh().inertia * (records[last].motion.V0() - records[0].motion.V0()), impulse,
              0.01 * contact.mesh().inertia * swing);
  EXPECT_GT(swing, 0.1);
}

TEST(SimplifiedDynamic, a_large_inertia_hardly_moves_and_none_follows_the_load) {
  const SingleContact inert("quasistatic", "step"), moving("simplified", "step");
  // Half the force needs 0.63 of the approach: H_0 follows the share within the time of its jump, but not with inertia.
  const auto largest_speed = [](const std::vector<StepRecord>& records) {
    double largest = 0.0;
    for (const StepRecord& record : records) largest = std::max(largest, std::abs(record.motion.V0()));
    return largest;
  };
  EXPECT_GT(largest_speed(inert.records()), 0.3 / 0.025);
  EXPECT_LT(largest_speed(moving.records()), 2.0);
}

TEST(SinglePath, has_one_contact_until_its_exit) {
  const CaseInput problem = table3_case();
  const ContactPath path(*problem.pair.line, problem.scales, problem.pair.pinion_speed, problem.pair.line->entry(),
                         MeshGeometry::single);
  EXPECT_EQ(path.contacts_after(0.0), std::vector<int>{0});
  EXPECT_DOUBLE_EQ(path.next_event(0.0), path.exit_time(0));
  EXPECT_EQ(path.contacts_after(0.99 * path.exit_time(0)), std::vector<int>{0});
  EXPECT_TRUE(path.contacts_after(path.exit_time(0)).empty());
  EXPECT_NEAR(
      path.time_at(0.0),
      -problem.pair.line->entry() / (problem.pair.line->exit() - problem.pair.line->entry()) * path.exit_time(0), 1e-9);
}

}  // namespace
}  // namespace gearfilm
