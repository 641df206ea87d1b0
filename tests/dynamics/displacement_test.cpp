// Jumps of the motion that the films follow, and marches that go on from a state.
#include <algorithm>
#include <cmath>

#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// Two contacts, the second of which entered a little while ago.
class Displacement : public testing::Test {
protected:
  Displacement() : march(table3_case(with(before_an_entry(), {{"grid.y_half", "1.5"}}))) {
    march.start();
    march.run(0.5);
    T = march.march().T();
    before = march.march().state();
  }

  static const std::vector<double>& pressure(const PairState& state, std::size_t contact) {
    return values_of(state.films[contact], field::pressure);
  }

  double force_of(const PairState& state, std::size_t contact) const {
    return integral(march.grid(), pressure(state, contact));
  }

  /// A contact at its place of now, with a film that knows nothing of the march's.
  ContactFilm film_of(std::size_t contact) {
    ContactFilm film(march.discretisation(), march.problem().scales, march.problem().numerics.solver.multigrid);
    move_surfaces(film, march.mesh().contact(march.march().contacts()[contact].number, T).conditions);
    return film;
  }

  static std::vector<double> mass(ContactFilm& film, const PairState& state, std::size_t contact) {
    std::vector<double> mass(pressure(state, contact).size());
    film.mass(pressure(state, contact), state.motion.H0(), mass);
    return mass;
  }

  /// Root mean square of a film's G after a jump with d(rho H)/dT = its rate before + (rho H - rho H before)/dT.
  double residual(const PairState& from, const PairState& to, std::size_t contact) {
    ContactFilm film = film_of(contact);
    const double shift = 1.0 / march.problem().numerics.steps.dT;
    const std::vector<double> mass_before = mass(film, from, contact);
    std::vector<double> rate = values_of(from.films[contact], field::rate), mass_after = mass(film, to, contact);
    for (std::size_t n = 0; n < rate.size(); ++n) rate[n] += shift * (mass_after[n] - mass_before[n]);
    std::vector<double> rows(rate.size());
    film.residual(pressure(to, contact), to.motion.H0(), {rate, shift}, rows);
    double sum = 0.0;
    for (const double row : rows) sum += row * row;
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return std::sqrt(sum / (march.grid().nx() * march.grid().rows()));
  }

  /// The same over the nodes of all films, which are solved together.
  double residual(const PairState& from, const PairState& to) {
    double sum = 0.0;
    for (std::size_t k = 0; k < contacts; ++k) sum += std::pow(residual(from, to, k), 2);
    return std::sqrt(sum / contacts);
  }

  /// Jumps to another H0 with one Newton solution for each film.
  void expect_one_step_to(double H0) {
    const PairState from = march.march().state();
    march.march().displace({H0, from.motion.V0()});
    const PairState to = march.march().state();
    ASSERT_EQ(to.films.size(), contacts);
    PairState unmoved = from;
    unmoved.motion = to.motion;
    SCOPED_TRACE("at H0 = " + std::to_string(H0));
    EXPECT_LE(residual(from, to), (1.0 + 1e-6) * tolerance());  // the same number, added up in another order
    for (std::size_t k = 0; k < contacts; ++k) {
      SCOPED_TRACE("film " + std::to_string(k));
      EXPECT_GT(residual(from, unmoved, k), 100.0 * tolerance());
    }
  }

  /// In the core nothing can flow in a time step: after a jump the oil is where it was, the bodies have given way.
  void expect_same_oil_in_the_core(const PairState& after) {
    const double jump = after.motion.H0() - before.motion.H0();
    for (std::size_t k = 0; k < contacts; ++k) {
      ContactFilm film = film_of(k);
      const std::vector<double> still = mass(film, before, k), moved = mass(film, after, k);
      double largest = 0.0;
      int core = 0;
      for (std::size_t n = 0; n < still.size(); ++n) {
        if (std::min(pressure(before, k)[n], pressure(after, k)[n]) < 0.5) continue;
        largest = std::max(largest, std::abs(moved[n] - still[n]));
        ++core;
      }
      MPI_Allreduce(MPI_IN_PLACE, &core, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
      EXPECT_GT(core, 100);
      EXPECT_LT(maximum(largest), 0.1 * std::abs(jump)) << "film " << k;
    }
  }

  double tolerance() const { return march.problem().numerics.steps.newton.tolerance; }

  static constexpr std::size_t contacts = 2;
  RecordedMarch march;
  double T = 0.0;
  PairState before;
};

TEST_F(Displacement, of_the_velocity_leaves_the_films_and_moves_the_bodies) {
  constexpr double jump = 0.1, time = 0.05;
  march.run(T + time);
  const double H0 = march.motion().H0();
  march.march().resume(T, before);
  march.march().displace({before.motion.H0(), before.motion.V0() + jump});
  const PairState after = march.march().state();
  for (std::size_t k = 0; k < contacts; ++k) EXPECT_EQ(pressure(after, k), pressure(before, k));
  march.run(T + time);
  // The force changes the velocity meanwhile: in this time, a hundredth of a swing, by much less than a tenth.
  EXPECT_NEAR(march.motion().H0() - H0, jump * time, 0.1 * jump * time);
}

TEST_F(Displacement, moves_every_film_by_one_implicit_step) {
  for (const double jump : {5e-3, -5e-3}) {
    march.march().resume(T, before);
    expect_one_step_to(before.motion.H0() + jump);
  }
}

// Those who look on see what the march goes on with.
TEST_F(Displacement, is_shown_with_the_forces_after_it) {
  march.march().displace({before.motion.H0() + 5e-3, before.motion.V0()});
  const PairState after = march.march().state();
  const StepRecord& record = march.records().back();
  EXPECT_EQ(record.motion.H0(), after.motion.H0());
  ASSERT_EQ(record.contacts.size(), contacts);
  for (std::size_t k = 0; k < contacts; ++k) {
    const double force = force_of(after, k);
    EXPECT_NEAR(record.contacts[k].quantities["force"], force, 1e-12 * force);
    EXPECT_LT(force, 0.999 * force_of(before, k));
  }
}

TEST_F(Displacement, changes_the_films_the_less_the_smaller_it_is) {
  double last[contacts] = {};
  for (double jump : {4e-3, 2e-3, 1e-3}) {
    march.march().resume(T, before);
    march.march().displace({before.motion.H0() + jump, before.motion.V0()});
    const PairState after = march.march().state();
    for (std::size_t k = 0; k < contacts; ++k) {
      const double change = largest_difference(pressure(after, k), pressure(before, k));
      EXPECT_GT(change, 0.0);
      if (last[k] > 0.0) {
        EXPECT_NEAR(change / last[k], 0.5, 0.1);
      }
      last[k] = change;
    }
  }
}

TEST_F(Displacement, keeps_the_oil_of_the_core) {
  march.march().displace({before.motion.H0() + 5e-3, before.motion.V0()});
  expect_same_oil_in_the_core(march.march().state());
}

// Larger than what one Newton solution is sure to follow: where it must be, the solution is found by parts of the jump.
// Three smaller jumps within the same time step come to the same films.
TEST_F(Displacement, by_a_tenth_of_the_approach_is_followed) {
  constexpr int parts = 3;
  for (const double jump : {0.15, -0.4}) {
    SCOPED_TRACE("jump by " + std::to_string(jump));
    march.march().resume(T, before);
    march.march().displace({before.motion.H0() + jump, before.motion.V0()});
    const PairState after = march.march().state();
    EXPECT_EQ(after.motion.H0(), before.motion.H0() + jump);
    expect_same_oil_in_the_core(after);
    march.march().resume(T, before);
    for (int n = 1; n <= parts; ++n) expect_one_step_to(before.motion.H0() + jump * n / parts);
    const PairState in_parts = march.march().state();
    for (std::size_t k = 0; k < contacts; ++k) {
      const double force = force_of(after, k), change = force - force_of(before, k), other = force_of(in_parts, k);
      report("film %d: force changed by %.4f, in three parts by %.4f", static_cast<int>(k), change,
             other - force_of(before, k));
      EXPECT_GT(std::abs(change), 1.0);
      EXPECT_NEAR(other, force, 1e-4 * std::abs(change));
    }
    EXPECT_LE(residual(before, after), (1.0 + 1e-6) * tolerance());
  }
}

// Nobody advances it: it is carried through jump, time steps and state as it is.
TEST_F(Displacement, carries_a_field_it_does_not_know) {
  const std::vector<double> temperature(pressure(before, 0).size(), 0.125);
  PairState warm = before;
  for (ContactFields& fields : warm.films) fields["temperature"] = temperature;
  march.march().resume(T, warm);
  march.march().displace({before.motion.H0() + 1e-3, before.motion.V0()});
  march.run(T + 0.1);
  for (const ContactFields& fields : march.march().state().films) EXPECT_EQ(fields.at("temperature"), temperature);
}

TEST_F(Displacement, a_resumed_march_goes_on_as_it_would_have) {
  march.run(T + 0.2);
  const Motion end = march.motion();
  march.march().resume(T, before);
  march.run(T + 0.2);
  EXPECT_NEAR(march.motion().H0(), end.H0(), 1e-7);
  EXPECT_NEAR(march.motion().V0(), end.V0(), 1e-7);
  PairState crowd = before;
  crowd.films.push_back(before.films.front());
  EXPECT_THROW(march.march().resume(T, crowd), std::logic_error);
}

}  // namespace
}  // namespace gearfilm
