// The quantities of a march, from records made up by hand: mesh period 1, static force 10.
#include <gtest/gtest.h>

#include "dynamics/march_statistics.hpp"

namespace gearfilm {
namespace {

constexpr double mesh_period = 1.0;
constexpr double static_force = 10.0;

/// A contact whose quantities all differ.
ContactRecord contact(int number, double position, double force, double film = 1.0) {
  ContactQuantities quantities;
  quantities["force"] = force;
  quantities["h_central"] = film;
  quantities["h_min"] = 0.9 * film;
  quantities["p_max"] = 0.1 * force;
  return {number, position, quantities};
}

StepRecord step(double T, double dT, const std::vector<ContactRecord>& contacts, const Motion& motion = {}) {
  StepRecord record;
  record.T = T;
  record.dT = dT;
  record.motion = motion;
  record.contacts = contacts;
  record.newton = 2;
  record.krylov = 5;
  record.wall_seconds = 0.5;
  return record;
}

MarchStatistics statistics_of(const std::vector<StepRecord>& records, const AvailableModels& given = {}) {
  MarchStatistics statistics(mesh_period, static_force);
  for (const StepRecord& record : records) statistics.add(record, given);
  return statistics;
}

TEST(MarchStatistics, a_step_belongs_to_the_period_in_which_it_ends) {
  const auto one = std::vector<ContactRecord>{contact(0, 0.0, 10.0)};
  const MarchStatistics statistics =
      statistics_of({step(0.0, 0.0, one), step(0.5, 0.5, one), step(1.0 + 1e-13, 0.5, one, {1.0, 2.0}),
                     step(1.5, 0.5, one), step(2.0 - 1e-13, 0.5, one, {3.0, 4.0}), step(2.25, 0.25, one)});
  ASSERT_EQ(statistics.periods().size(), 3U);
  const auto& periods = statistics.periods();
  EXPECT_EQ(periods[0]["steps"], 2);  // a starting state is no step
  EXPECT_EQ(periods[1]["steps"], 2);
  EXPECT_EQ(periods[2]["steps"], 1);
  EXPECT_EQ(periods[0]["H0"], 1.0);
  EXPECT_EQ(periods[0]["V0"], 2.0);
  EXPECT_EQ(periods[1]["H0"], 3.0);
}

TEST(MarchStatistics, work_is_summed_over_the_steps_of_a_period) {
  const MarchStatistics statistics =
      statistics_of({step(0.0, 0.0, {contact(0, 0.0, 10.0)}), step(0.5, 0.5, {contact(0, 0.0, 10.0)}),
                     step(1.0, 0.5, {contact(0, 0.0, 5.0), contact(1, 0.0, 5.0)})});
  const PeriodQuantities& period = statistics.periods().at(0);
  EXPECT_EQ(period["contact_steps"], 3);
  EXPECT_EQ(period["newton_iterations"], 4);
  EXPECT_EQ(period["krylov_iterations"], 10);
  EXPECT_EQ(period["wall_time"], 1.0);
}

// Forces on all contacts are twice and half the static one, of which asperities carry 1/4 and all.
TEST(MarchStatistics, asperities_carry_a_part_of_the_force_of_the_moment) {
  const auto rough = [](double force, double by_asperities) {
    ContactRecord record = contact(0, 0.0, force);
    record.quantities["asperity_force"] = by_asperities;
    return record;
  };
  const MarchStatistics statistics =
      statistics_of({step(0.0, 0.0, {rough(20.0, 5.0)}), step(0.5, 0.5, {rough(12.0, 1.0), rough(8.0, 4.0)}),
                     step(0.5, 0.0, {rough(5.0, 5.0)}), step(1.0, 0.5, {rough(5.0, 5.0)})},
                    {.asperities = true});
  EXPECT_DOUBLE_EQ(statistics.periods().at(0)["asperity_load_share_mean"].value(), 0.5 * (0.25 + 1.0));
  EXPECT_EQ(step(0.0, 0.0, {}).asperity_load_share(), 0.0);
}

TEST(MarchStatistics, extremes_are_kept_by_contact_and_of_the_sum) {
  const MarchStatistics statistics =
      statistics_of({step(0.25, 0.25, {contact(0, 0.0, 8.0, 3.0)}),
                     step(0.5, 0.25, {contact(0, 0.1, 7.0, 2.0), contact(1, -0.5, 4.0, 5.0)}),
                     step(0.75, 0.25, {contact(0, 0.2, 2.0, 4.0), contact(1, -0.4, 3.0, 6.0)}),
                     step(1.25, 0.5, {contact(1, 0.0, 6.0, 7.0)})});
  const PeriodQuantities& first = statistics.periods().at(0);
  EXPECT_DOUBLE_EQ(first["force_ratio_max"].value(), 8.0);
  EXPECT_DOUBLE_EQ(first["total_force_ratio_max"].value(), 11.0);
  EXPECT_DOUBLE_EQ(first["total_force_ratio_min"].value(), 5.0);
  EXPECT_DOUBLE_EQ(first["p_max"].value(), 0.8);
  EXPECT_DOUBLE_EQ(first["h_min"].value(), 1.8);
  const PeriodQuantities& second = statistics.periods().at(1);
  EXPECT_DOUBLE_EQ(second["total_force_ratio_max"].value(), 6.0);
  EXPECT_DOUBLE_EQ(second["total_force_ratio_min"].value(), 6.0);
  EXPECT_DOUBLE_EQ(second["h_min"].value(), 6.3);
}

TEST(MarchStatistics, pitch_film_is_the_one_nearest_the_pitch_point_in_its_period) {
  const MarchStatistics statistics =
      statistics_of({step(0.25, 0.25, {contact(0, -0.3, 10.0, 1.0)}), step(0.5, 0.25, {contact(0, -0.05, 10.0, 2.0)}),
                     step(0.75, 0.25, {contact(0, 0.2, 5.0, 3.0), contact(1, -0.8, 5.0, 4.0)}),
                     step(1.25, 0.50, {contact(0, 0.7, 5.0, 5.0), contact(1, -0.3, 5.0, 6.0)})});
  EXPECT_DOUBLE_EQ(statistics.periods().at(0)["pitch_h_central"].value(), 2.0);
  EXPECT_DOUBLE_EQ(statistics.periods().at(0)["pitch_h_min"].value(), 1.8);
  EXPECT_DOUBLE_EQ(statistics.periods().at(1)["pitch_h_central"].value(), 6.0);
}

TEST(MarchStatistics, entry_film_is_that_of_the_first_step_after_the_entry) {
  const MarchStatistics statistics =
      statistics_of({step(0.0, 0.0, {contact(0, 0.0, 10.0)}), step(0.5, 0.5, {contact(0, 0.1, 10.0)}),
                     step(0.5, 0.0, {contact(0, 0.1, 10.0), contact(1, -0.9, 0.5, 2.0)}),
                     step(0.75, 0.25, {contact(0, 0.2, 8.0), contact(1, -0.8, 2.0, 3.0)}),
                     step(1.0, 0.25, {contact(0, 0.3, 6.0), contact(1, -0.7, 4.0, 4.0)})});
  ASSERT_TRUE(statistics.periods().at(0)["entry_h_central"]);
  EXPECT_DOUBLE_EQ(statistics.periods()[0]["entry_h_central"].value(), 3.0);
  EXPECT_DOUBLE_EQ(statistics.periods()[0]["entry_h_min"].value(), 2.7);
}

TEST(MarchStatistics, an_entry_at_the_end_of_a_period_has_its_film_in_the_next) {
  const MarchStatistics statistics =
      statistics_of({step(0.0, 0.0, {contact(0, 0.0, 10.0)}), step(1.0, 1.0, {contact(0, 0.1, 10.0)}),
                     step(1.0, 0.0, {contact(0, 0.1, 10.0), contact(1, -0.9, 0.5, 2.0)}),
                     step(1.25, 0.25, {contact(0, 0.2, 8.0), contact(1, -0.8, 2.0, 3.0)})});
  EXPECT_FALSE(statistics.periods().at(0)["entry_h_central"]);
  ASSERT_TRUE(statistics.periods().at(1)["entry_h_central"]);
  EXPECT_DOUBLE_EQ(statistics.periods()[1]["entry_h_central"].value(), 3.0);
}

TEST(MarchStatistics, events_are_the_changes_of_the_contacts) {
  const Motion motion{-1.5, 0.6};
  const MarchStatistics statistics = statistics_of(
      {step(0.0, 0.0, {contact(0, 0.0, 10.0)}), step(0.4, 0.4, {contact(0, 0.1, 10.0)}),
       step(0.4, 0.0, {contact(0, 0.1, 10.0), contact(1, -0.9, 0.0)}, motion),
       step(0.7, 0.3, {contact(0, 0.1, 5.0), contact(1, -0.9, 5.0)}), step(0.7, 0.0, {contact(1, -0.8, 5.0)}),
       // The next pair is taken over at once.
       step(1.7, 1.0, {contact(2, -0.9, 10.0)})});
  const auto& events = statistics.events();
  ASSERT_EQ(events.size(), 4U);  // the contacts of the start have not entered
  EXPECT_EQ(events[0].kind, MeshEvent::Kind::entry);
  EXPECT_EQ(events[0].contact, 1);
  EXPECT_EQ(events[0].T, 0.4);
  EXPECT_EQ(events[0].motion.H0(), motion.H0());
  EXPECT_EQ(events[0].motion.V0(), motion.V0());
  EXPECT_EQ(events[1].kind, MeshEvent::Kind::exit);
  EXPECT_EQ(events[1].contact, 0);
  EXPECT_EQ(events[1].T, 0.7);
  EXPECT_EQ(events[2].kind, MeshEvent::Kind::exit);
  EXPECT_EQ(events[2].contact, 1);
  EXPECT_EQ(events[3].kind, MeshEvent::Kind::entry);
  EXPECT_EQ(events[3].contact, 2);
}

TEST(MarchStatistics, contact_is_lost_below_a_fiftieth_of_the_static_force) {
  const double threshold = 0.02 * static_force;
  const MarchStatistics statistics = statistics_of(
      {step(0.1, 0.1, {contact(0, 0.0, 1.001 * threshold, 9.0)}),
       step(0.2, 0.1, {contact(0, 0.0, 0.999 * threshold, 2.0)}), step(0.3, 0.1, {contact(0, 0.0, 0.0, 5.0)}),
       // Two contacts that carry enough together.
       step(0.4, 0.1, {contact(0, 0.0, 0.6 * threshold, 8.0), contact(1, 0.0, 0.6 * threshold, 7.0)}),
       step(1.2, 0.8, {contact(0, 0.0, 0.4 * threshold, 3.0), contact(1, 0.0, 0.4 * threshold, 4.0)})});
  const auto& losses = statistics.losses();
  ASSERT_EQ(losses.size(), 2U);
  EXPECT_EQ(losses[0].begin, 0.2);
  EXPECT_EQ(losses[0].end, 0.3);
  EXPECT_EQ(losses[0].largest_central_film, 5.0);
  EXPECT_EQ(losses[1].begin, 1.2);
  EXPECT_EQ(losses[1].end, 1.2);
  EXPECT_EQ(losses[1].largest_central_film, 4.0);
}

TEST(MarchStatistics, a_dry_march_has_no_films) {
  const MarchStatistics statistics = statistics_of(
      {step(0.0, 0.0, {contact(0, 0.0, 10.0)}), step(0.5, 0.5, {contact(0, 0.1, 5.0), contact(1, -0.9, 5.0)})},
      AvailableModels{.film = false});
  const PeriodQuantities& period = statistics.periods().at(0);
  EXPECT_FALSE(period["h_min"]);
  EXPECT_FALSE(period["pitch_h_central"]);
  EXPECT_FALSE(period["entry_h_central"]);
  EXPECT_DOUBLE_EQ(period["p_max"].value(), 0.5);
}

}  // namespace
}  // namespace gearfilm
