// Films near the pitch point of two motions: the largest difference within a quarter of a swing.
#include "orbits/pitch_films.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "orbits/orbit_errors.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

constexpr ContactQuantityName central_film = "h_central";

/// The films of one mesh period in which the central film swings about 1 with the pair, a phase behind the pitch point.
std::vector<PitchFilm> swinging_films(const MeshModel& mesh, double amplitude, double phase, int steps) {
  PitchFilmRecorder recorder(mesh);
  const double period = mesh.path.mesh_period(), pitch = mesh.path.time_at(0.0);
  for (int n = 1; n <= 2 * steps; ++n) {
    StepRecord record;
    record.T = n * period / steps;
    record.dT = period / steps;
    for (int number : mesh.path.contacts_after(record.T)) {
      ContactRecord contact{number, mesh.path.position(number, record.T), {}};
      const double time = mesh.path.time_at(contact.position) - pitch;
      contact.quantities["h_central"] =
          1.0 + amplitude * std::sin(2.0 * std::numbers::pi * mesh.frequency() * time + phase);
      record.contacts.push_back(contact);
    }
    recorder.add(record);
  }
  return recorder.within(period, 2.0 * period);
}

/// Swings 16 times in a mesh period.
MeshModel swinging_mesh() { return mesh_of(table3_case({{"pinion.speed_rpm", "600"}})); }

TEST(PitchFilms, are_those_within_a_quarter_of_a_swing_or_a_fortieth_of_a_mesh_period) {
  const MeshModel calm = mesh_of(table3_case());  // less than 10 times
  const double period = calm.path.mesh_period();
  EXPECT_NEAR(swinging_films(calm, 0.1, 0.0, 400).back().time, period / 40, period / 400);
  const MeshModel mesh = swinging_mesh();
  const std::vector<PitchFilm> films = swinging_films(mesh, 0.1, 0.0, 400);
  const double quarter = 0.25 / mesh.frequency(), step = mesh.path.mesh_period() / 400;
  EXPECT_NEAR(films.front().time, -quarter, step);
  EXPECT_NEAR(films.back().time, quarter, step);
  EXPECT_NEAR(static_cast<double>(films.size()), 2.0 * quarter / step, 2.0);
}

// Waves with one film at the pitch point, one of them higher by a fifth of its swing; the steps of the other are
// longer.
TEST(PitchFilms, differ_where_their_waves_do_though_those_at_the_pitch_point_are_equal) {
  const MeshModel mesh = swinging_mesh();
  const auto change = largest_relative_change(swinging_films(mesh, 0.1, 0.0, 1600),
                                              swinging_films(mesh, 0.12, 0.0, 920), central_film.place);
  ASSERT_TRUE(change);
  EXPECT_NEAR(std::abs(*change), 0.02 / 0.9, 5e-4);
}

TEST(PitchFilms, of_other_phases_differ_by_more_than_at_the_pitch_point) {
  const MeshModel mesh = swinging_mesh();
  const double phase = 0.5 * std::numbers::pi;
  const auto change = largest_relative_change(swinging_films(mesh, 0.1, phase + 0.1, 1600),
                                              swinging_films(mesh, 0.1, phase - 0.1, 1600), central_film.place);
  ASSERT_TRUE(change);
  EXPECT_NEAR(std::abs(*change), 0.2 * 0.1, 2e-3);  // at the pitch point both have 1 + 0.1 cos(0.1)
}

TEST(PitchFilms, make_the_error_bar_of_orbits_whose_films_at_the_pitch_point_are_equal) {
  const MeshModel mesh = swinging_mesh();
  FoundOrbit found{.discretisation = FilmDiscretisation::central};
  found.own.quantities.values[PeriodQuantityName("pitch_h_central").place] = 1.0;
  found.own.pitch_films = swinging_films(mesh, 0.1, 0.0, 1600);
  found.coarse = found.own;
  const auto error = [&found] {
    const std::vector<OrbitError> errors = errors_of(found);
    return std::ranges::find(errors, "pitch_h_central", &OrbitError::name)->bar.value().error;
  };
  EXPECT_EQ(error(), 0.0);
  found.coarse->pitch_films = swinging_films(mesh, 0.12, 0.0, 800);
  EXPECT_NEAR(error(), 0.02 / 0.9 / 3.0, 5e-4);
}

TEST(PitchFilms, are_none_of_bodies_without_inertia) {
  MeshModel mesh = mesh_of(table3_case());
  mesh.inertia = 0.0;
  PitchFilmRecorder recorder(mesh);
  StepRecord record;
  record.T = mesh.path.mesh_period();
  record.dT = 0.1;
  record.contacts = {{0, 0.0, {}}};
  recorder.add(record);
  EXPECT_TRUE(recorder.within(0.0, 2.0 * record.T).empty());
  EXPECT_FALSE(largest_relative_change({}, {}, central_film.place));
}

}  // namespace
}  // namespace gearfilm
