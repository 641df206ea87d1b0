// What long work says of itself, and who tells it.
#include "output/progress.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "pair_case.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

TEST(LongWork, is_silent_at_first_and_then_says_what_it_is_at) {
  testing::internal::CaptureStdout();
  {
    LongWork silent(PETSC_COMM_WORLD, 1e6), due(PETSC_COMM_WORLD, 0.0);
    silent.report("not yet");
    due.report("the first iteration");
  }
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_THAT(said, testing::Not(testing::HasSubstr("not yet")));
  const bool first = rank_in(PETSC_COMM_WORLD) == 0;
  EXPECT_EQ(said.find("0 s: the first iteration") != std::string::npos, first) << said;
}

TEST(LongWork, stationary_films_tell_their_watcher_of_every_iteration) {
  CaseInput problem = table3_case({{"grid.nx", "65"}, {"grid.ny", "33"}});
  std::vector<std::string> told;
  problem.numerics.solver.newton.watcher = [&](const std::string& text) { told.push_back(text); };
  const StationaryResult film = pitch_film(problem.scales, problem.numerics, discretise(PETSC_COMM_WORLD, problem));
  EXPECT_GE(told.size(), static_cast<std::size_t>(film.counts.newton));
  EXPECT_THAT(told, testing::Each(testing::HasSubstr("Newton iteration ")));
}

}  // namespace
}  // namespace gearfilm
