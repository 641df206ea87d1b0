// Jumps of the motion that the films follow, and marches that go on from a state.
#include <algorithm>
#include <cmath>

#include "pair_case.hpp"

namespace gearfilm {
namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) largest = std::max(largest, std::abs(a[n] - b[n]));
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  return largest;
}

class Displacement : public testing::Test {
protected:
  Displacement() : march(table3_case(after_leaving())) {
    march.start();
    march.run(0.5);
    before = march.march().state();
  }

  /// The films' own mass of the first contact's state.
  std::vector<double> mass(const PairState& state) {
    ContactFilm film(march.discretisation(), march.problem().scales, march.problem().numerics.solver.multigrid);
    const int number = march.march().contacts().front().number;
    film.set_conditions(march.mesh().contact(number, march.march().T()).conditions);
    std::vector<double> mass(pressure(state).size());
    film.mass(pressure(state), state.motion.H0, mass);
    return mass;
  }

  /// Pressures of the first contact.
  static const std::vector<double>& pressure(const PairState& state) {
    return values_of(state.films.front(), field::pressure);
  }

  RecordedMarch march;
  PairState before;
};

TEST_F(Displacement, of_the_velocity_leaves_the_films) {
  march.march().displace({before.motion.H0, before.motion.V0 + 0.1});
  const PairState after = march.march().state();
  EXPECT_EQ(after.motion.V0, before.motion.V0 + 0.1);
  EXPECT_EQ(pressure(after), pressure(before));
}

TEST_F(Displacement, changes_the_films_the_less_the_smaller_it_is) {
  double last = 0.0;
  for (double jump : {4e-3, 2e-3, 1e-3}) {
    march.march().resume(march.march().T(), before);
    march.march().displace({before.motion.H0 + jump, before.motion.V0});
    const double change = largest_difference(pressure(march.march().state()), pressure(before));
    EXPECT_GT(change, 0.0);
    if (last > 0.0) {
      EXPECT_NEAR(change / last, 0.5, 0.1);
    }
    last = change;
  }
}

// In the core nothing can flow in a time step: the oil stays where it is, the bodies give way.
TEST_F(Displacement, keeps_the_oil_of_the_core) {
  const std::vector<double> still = mass(before);
  march.march().displace({before.motion.H0 + 5e-3, before.motion.V0});
  const PairState after = march.march().state();
  const std::vector<double> moved = mass(after);
  double largest = 0.0;
  for (std::size_t n = 0; n < still.size(); ++n) {
    if (pressure(before)[n] > 0.5) largest = std::max(largest, std::abs(moved[n] - still[n]));
  }
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  EXPECT_LT(largest, 0.1 * 5e-3);
}

// Larger than one Newton solution follows: the jump is made in parts.
TEST_F(Displacement, by_a_tenth_of_the_approach_is_followed) {
  march.march().displace({before.motion.H0 + 0.15, before.motion.V0});
  EXPECT_EQ(march.motion().H0, before.motion.H0 + 0.15);
  march.run(0.7);
  EXPECT_TRUE(std::isfinite(march.motion().H0));
}

// Nobody advances it: it is carried through jump, time steps and state as it is.
TEST_F(Displacement, carries_a_field_it_does_not_know) {
  const std::vector<double> temperature(pressure(before).size(), 0.125);
  PairState warm = before;
  for (ContactFields& fields : warm.films) fields["temperature"] = temperature;
  march.march().resume(march.march().T(), warm);
  march.march().displace({before.motion.H0 + 1e-3, before.motion.V0});
  march.run(0.6);
  for (const ContactFields& fields : march.march().state().films) EXPECT_EQ(fields.at("temperature"), temperature);
}

TEST_F(Displacement, a_resumed_march_goes_on_as_it_would_have) {
  const double T = march.march().T();
  march.run(T + 0.2);
  const Motion end = march.motion();
  march.march().resume(T, before);
  march.run(T + 0.2);
  EXPECT_NEAR(march.motion().H0, end.H0, 1e-7);
  EXPECT_NEAR(march.motion().V0, end.V0, 1e-7);
  PairState crowd = before;
  crowd.films.push_back(before.films.front());
  EXPECT_THROW(march.march().resume(T, crowd), std::logic_error);
}

}  // namespace
}  // namespace gearfilm
