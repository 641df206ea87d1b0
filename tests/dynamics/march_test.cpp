// Marches through entries and exits: any number of processes, any number of contacts, and the end of a march that
// leaves its grid.
#include "pair_case.hpp"

namespace gearfilm {
namespace {

void expect_same_records(const StepRecord& record, const StepRecord& expected) {
  SCOPED_TRACE("T = " + std::to_string(expected.T));
  // The iterations stop at slightly different states: Newton's tolerance is 6e-6.
  constexpr double tolerance = 1e-5;
  const auto expect_near = [&](double value, double other) { EXPECT_NEAR(value, other, tolerance * std::abs(other)); };
  EXPECT_DOUBLE_EQ(record.T, expected.T);
  EXPECT_DOUBLE_EQ(record.dT, expected.dT);
  expect_near(record.motion.H0(), expected.motion.H0());
  expect_near(record.motion.V0(), expected.motion.V0());
  ASSERT_EQ(record.contacts.size(), expected.contacts.size());
  for (std::size_t k = 0; k < expected.contacts.size(); ++k) {
    const ContactQuantities &quantities = record.contacts[k].quantities, &others = expected.contacts[k].quantities;
    EXPECT_EQ(record.contacts[k].number, expected.contacts[k].number);
    EXPECT_DOUBLE_EQ(record.contacts[k].position, expected.contacts[k].position);
    expect_near(quantities["force"], others["force"]);
    expect_near(quantities["h_central"], others["h_central"]);
    expect_near(quantities["h_min"], others["h_min"]);
    expect_near(quantities["p_central"], others["p_central"]);
    expect_near(quantities["p_max"], others["p_max"]);
  }
}

TEST(Processes, same_history_on_any_number_of_processes) {
  int processes = 1;
  MPI_Comm_size(PETSC_COMM_WORLD, &processes);
  if (processes == 1) GTEST_SKIP() << "nothing to compare on one process";
  RecordedMarch together(table3_case(before_an_entry()));
  RecordedMarch alone(table3_case(before_an_entry()), PETSC_COMM_SELF);
  for (RecordedMarch* march : {&together, &alone}) {
    march->start();
    march->run(0.4);
  }
  EXPECT_EQ(alone.records().front().contacts.size(), 1U);
  EXPECT_EQ(alone.records().back().contacts.size(), 2U);
  ASSERT_EQ(together.records().size(), alone.records().size());
  for (std::size_t n = 0; n < alone.records().size(); ++n)
    expect_same_records(together.records()[n], alone.records()[n]);
}

TEST(March, a_run_in_pieces_reaches_the_same_end) {
  RecordedMarch whole(table3_case(before_an_entry())), pieces(table3_case(before_an_entry()));
  whole.start();
  whole.run(0.4);
  pieces.start();
  for (const double T : {0.1, 0.3, 0.4}) pieces.run(T);
  EXPECT_DOUBLE_EQ(pieces.records().back().T, whole.records().back().T);
  // Every piece begins with a step of first order: the difference is of the size of the error of a step of 0.05.
  EXPECT_NEAR(pieces.motion().H0(), whole.motion().H0(), 1e-3);
  EXPECT_NEAR(pieces.motion().V0(), whole.motion().V0(), 1e-3);
}

const ContactRecord& of_contact(const StepRecord& record, int contact) {
  for (const ContactRecord& candidate : record.contacts) {
    if (candidate.number == contact) return candidate;
  }
  throw std::out_of_range("no contact " + std::to_string(contact));
}

TEST(March, steps_that_were_halved_count_when_they_are_recalled) {
  const CaseInput problem = table3_case(after_leaving());
  Memory memory;
  const auto march_to = [&](double T) {
    MeshMarch march = make_march(
        problem, discretise(PETSC_COMM_WORLD, problem), mesh_of(problem),
        [](const StepRecord&, const std::vector<ActiveContact>&) {}, &memory);
    march.start(problem.march.start_motion);
    march.run(T);
    return march.halved_steps();
  };
  EXPECT_EQ(march_to(0.1), 0);
  memory.known = memory.kept.back();
  memory.known->records.resize(3);
  for (int n = 0; n < 3; ++n) memory.known->records[n].halvings = n;
  EXPECT_EQ(march_to(0.1), 2);
}

// Two and three contacts in turn; at an event, neither the motion nor the films that stay know of it yet.
TEST(March, three_contacts_share_the_force_and_come_and_go) {
  RecordedMarch march(
      input_case("high_contact_ratio.yaml", {{"grid.nx", "65"}, {"grid.ny", "33"}, {"time.dt", "0.05"}}));
  march.start();
  const StepRecord& rest = march.records().front();
  ASSERT_EQ(rest.contacts.size(), 3U);
  EXPECT_NEAR(rest.pressure_integral() / march.static_force(), 1.0, 1e-6);
  for (const ContactRecord& contact : rest.contacts) {
    EXPECT_NEAR(contact.quantities["force"] / march.static_force(), 1.0 / 3.0, 0.05);
  }
  march.run(5.2);
  const auto events = statistics_of(march).events();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].kind, MeshEvent::Kind::exit);
  EXPECT_EQ(events[0].contact, 0);
  EXPECT_NEAR(events[0].T, march.path().exit_time(0), 1e-9);
  EXPECT_EQ(events[1].kind, MeshEvent::Kind::entry);
  EXPECT_EQ(events[1].contact, 3);
  EXPECT_NEAR(events[1].T, march.path().entry_time(3), 1e-9);
  for (std::size_t n = 1; n < march.records().size(); ++n) {
    const StepRecord &before = march.records()[n - 1], &after = march.records()[n];
    if (after.dT > 0.0) continue;
    EXPECT_EQ(after.T, before.T);
    EXPECT_EQ(after.motion.H0(), before.motion.H0());
    EXPECT_EQ(after.motion.V0(), before.motion.V0());
    for (const int contact : {1, 2}) {
      EXPECT_EQ(of_contact(after, contact).quantities["force"], of_contact(before, contact).quantities["force"]);
    }
  }
  EXPECT_EQ(march.records().back().contacts.size(), 3U);
}

// At 8000 rpm the force reaches 1.33 times the static one, under which the ellipse is as long as a face of 2.2 b.
TEST(March, a_contact_that_outgrows_its_face_ends_the_march) {
  CaseInput problem = table3_case({{"grid.nx", "65"},
                                   {"grid.ny", "33"},
                                   {"time.dt", "0.05"},
                                   {"pinion.speed_rpm", "8000"},
                                   {"grid.y_half", "1.1"}});
  problem.numerics.margins.face = 1.1 / problem.scales.hertz.ellipticity;
  RecordedMarch march(problem);
  march.start();
  const std::string message = solve_error_of([&] { march.run(march.path().mesh_period()); });
  const StepRecord& last = march.records().back();
  ASSERT_EQ(last.contacts.size(), 1U);
  std::ostringstream contact;
  contact << "contact " << last.contacts.front().number << " at xi = ";
  for (const std::string& word : {contact.str(), std::string("edges of the teeth"), std::string("crowning")}) {
    EXPECT_NE(message.find(word), std::string::npos) << word << " in: " << message;
  }
  // The last state shown was still inside.
  EXPECT_LT(last.contacts.front().quantities["force"] / march.static_force(), 1.34);
  EXPECT_GT(last.contacts.front().quantities["force"] / march.static_force(), 1.2);
}

}  // namespace
}  // namespace gearfilm
