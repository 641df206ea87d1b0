// Films over a whole face against those of other grids, other contacts and another program.
#include <algorithm>

#include "face_case.hpp"
#include "film/face_quantities.hpp"

namespace gearfilm {
namespace {

constexpr auto central = FilmDiscretisation::central;

/// As tightly as films of one contact on different grids of rows are compared.
SolverOptions tight() {
  SolverOptions options;
  options.newton.tolerance = 1e-9;
  return options;
}

SolvedFilm face_film(const Face& face, int nx, const RowGrading& grading, Edge lower = Edge::symmetry,
                     MPI_Comm comm = PETSC_COMM_WORLD) {
  const Scales scales = face_scales(face);
  return {comm, scales, shape_over(rows_of_face(scales, grading, lower), nx), tight(), central};
}

/// The film with other ends of the face, from that with given ones.
struct ContinuedFilm {
  ContinuedFilm(const SolvedFilm& from, const Face& face)
      : scales(face_scales(face)),
        grid(from.grid),
        film(discretise(grid, scales, central), scales, MultigridOptions{}),
        result(continue_stationary(film, LoadCondition::force(scales.static_force), tight(), from.result.solution)) {}

  Scales scales;
  const Grid& grid;
  ContactFilm film;
  StationaryResult result;
};

// Two solutions to a residual of 1e-9.
template <class Film>
void expect_whole_face_is_half(const Film& all, const Film& half) {
  report("%d rows: %d and %d Newton iterations", all.grid.rows(), half.result.counts.newton, all.result.counts.newton);
  expect_whole_is_half(all.grid, whole_of(all.grid, all.film.total_pressure()), half.grid,
                       whole_of(half.grid, half.film.total_pressure()), 1e-6);
  expect_whole_is_half(all.grid, whole_of(all.grid, all.film.thickness()), half.grid,
                       whole_of(half.grid, half.film.thickness()), 1e-7);
  EXPECT_NEAR(all.result.solution.H0, half.result.solution.H0, 1e-7);
  EXPECT_NEAR(all.result.quantities.central_film, half.result.quantities.central_film, 1e-7);
  EXPECT_NEAR(all.result.quantities.smallest_film, half.result.quantities.smallest_film, 1e-7);
  const FaceQuantities of_all = face_quantities(all.film), of_half = face_quantities(half.film);
  EXPECT_NEAR(of_all.tilting_moment, 0.0, 1e-3);  // of 5000 if all load were at one end
  EXPECT_EQ(of_half.tilting_moment, 0.0);
  EXPECT_NEAR(of_all.side_flow_lower, of_all.side_flow_upper, 1e-6 * of_all.side_flow_upper);
  EXPECT_NEAR(of_half.side_flow_upper, of_all.side_flow_upper, 1e-6 * of_all.side_flow_upper);
  EXPECT_EQ(of_half.side_flow_lower, of_half.side_flow_upper);
  for (std::size_t row = 0; row < of_all.Y.size(); ++row) {
    EXPECT_EQ(of_all.Y[row], of_half.Y[row]);
    EXPECT_NEAR(of_all.line_load[row], of_half.line_load[row], 1e-6);
    EXPECT_NEAR(of_all.smallest_film[row], of_half.smallest_film[row], 1e-6);
  }
}

TEST(FaceFilm, on_half_the_rows_is_that_on_all_of_them) {
  const Face face = face_with(EndFace::half_space, relieved_ends());
  const SolvedFilm half = face_film(face, 65, few_rows), all = face_film(face, 65, few_rows, Edge::ambient);
  expect_whole_face_is_half(all, half);
  const Face free = face_with(EndFace::free, relieved_ends());
  expect_whole_face_is_half(ContinuedFilm(all, free), ContinuedFilm(half, free));
}

TEST(FaceFilm, is_the_same_on_any_number_of_processes) {
  const Face face = face_with(EndFace::half_space, {.slope = 5e-6 / face_width, .reliefs = relieved_ends().reliefs});
  const SolvedFilm distributed = face_film(face, 65, few_rows, Edge::ambient),
                   alone = face_film(face, 65, few_rows, Edge::ambient, PETSC_COMM_SELF);
  EXPECT_LT(relative_difference(whole_of(distributed.grid, distributed.film.thickness()),
                                whole_of(alone.grid, alone.film.thickness())),
            1e-7);
  const FaceQuantities together = face_quantities(distributed.film), single = face_quantities(alone.film);
  EXPECT_NEAR(together.tilting_moment, single.tilting_moment, 1e-6 * std::abs(single.tilting_moment));
  EXPECT_NEAR(together.side_flow_upper, single.side_flow_upper, 1e-6 * single.side_flow_upper);
  EXPECT_NEAR(together.side_flow_lower, single.side_flow_lower, 1e-6 * single.side_flow_lower);
  EXPECT_GT(single.side_flow_upper, 1.05 * single.side_flow_lower);  // where it opens
  EXPECT_EQ(together.smallest_film_at(), single.smallest_film_at());
}

/// Five digits that another program gives, with a residual of 1e-5.
constexpr double five_digits = 5e-5;

TEST(FaceFilm, of_the_case_study_is_that_of_another_program) {
  const FilmCase pitch = table3_pitch();
  const SolvedFilm solved(PETSC_COMM_WORLD, pitch, 129, 65, {}, Edge::ambient, central);
  const FilmQuantities& film = solved.result.quantities;
  EXPECT_NEAR(pitch.scales.thickness * film.central_film, 2.41493e-6, 5e-12);
  EXPECT_NEAR(pitch.scales.thickness * film.smallest_film, 2.16208e-6, 5e-12);
}

/// A crowned contact that does not reach the ends of its face, on equal rows over all of it; found from Hertz' pressure
/// about the place where it is expected.
struct CrownedFilm {
  /// Rows about some place; the contact about another.
  CrownedFilm(double slope, double middle, double contact)
      : scales(face_scales(face_with(EndFace::half_space, {.slope = slope}), radius_y)),
        grid(PETSC_COMM_WORLD, {65, -5.0, 2.5, rows(middle)}),
        film(discretise(grid, scales, central), scales, MultigridOptions{}) {
    const HertzContact hertz = hertz_contact({9e-3, radius_y, scales.solids.reduced_modulus}, face_load);
    FilmSolution guess{std::vector<double>(grid.local_size(), 0.0), 0.0};
    for (int i = 1; i < grid.nx() - 1; ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        const double x = grid.x(i) * scales.length / hertz.a, y = (grid.y(j) * scales.length - contact) / hertz.b;
        guess.pressure[i * grid.y_count() + j] =
            hertz.pressure / scales.pressure * std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
      }
    }
    guess.H0 = (1.2e-6 - hertz.approach + 0.5 * contact * contact / radius_y * (slope != 0.0)) / scales.thickness;
    result = continue_stationary(film, LoadCondition::force(scales.static_force), tight(), guess);
    face = face_quantities(film);
  }

  RowAxis rows(double middle) const {
    std::vector<double> y;
    for (int row = -56; row <= 56; ++row) y.push_back((middle + row * step) / scales.length);
    return {y, Edge::ambient, Edge::ambient};
  }

  static constexpr double radius_y = 0.5, step = face_width / 112;
  Scales scales;
  Grid grid;
  ContactFilm film;
  StationaryResult result;
  FaceQuantities face;
};

// The rows at the ends count where corners carry films.
TEST(FaceQuantitiesBetweenRows, are_what_the_nearer_row_beside_the_thinnest_has_more) {
  FaceQuantities face;
  face.Y = {-3.0, -1.0, 0.0, 1.0, 3.0};
  face.smallest_film = {0.1, 0.9, 0.5, 0.8, 2.0};
  face.corners_carry_films = false;
  EXPECT_EQ(face.smallest_film_at(), 0.0);
  EXPECT_DOUBLE_EQ(face.film_between_rows(), 0.3);
  face.smallest_film[1] = 0.2;  // beside an end
  EXPECT_DOUBLE_EQ(face.film_between_rows(), 0.3);
  face.corners_carry_films = true;
  EXPECT_DOUBLE_EQ(face.film_between_rows(), 0.1);
}

// theta y + y^2/(2 R_y) = (y + theta R_y)^2/(2 R_y) - theta^2 R_y/2: 14 rows towards -y.
TEST(FaceFilm, of_a_crowned_and_misaligned_contact_is_the_shifted_one) {
  const double slope = 49e-6 / face_width, shift = -slope * CrownedFilm::radius_y;
  ASSERT_NEAR(shift, -14.0 * CrownedFilm::step, 1e-15);
  const CrownedFilm sloping(slope, 0.0, shift), level(0.0, -shift, 0.0);
  report("%d and %d Newton iterations", sloping.result.counts.newton, level.result.counts.newton);
  const auto expect_same = [&](const Field<double>& a, const Field<double>& b) {
    const double off = relative_difference(whole_of(sloping.grid, a), whole_of(level.grid, b));
    EXPECT_LT(off, 1e-7);
  };
  expect_same(sloping.film.total_pressure(), level.film.total_pressure());
  expect_same(sloping.film.thickness(), level.film.thickness());
  const double deeper = 0.5 * slope * slope * CrownedFilm::radius_y;
  EXPECT_NEAR(deeper, 3.0625e-6, 1e-12);
  EXPECT_NEAR(sloping.result.solution.H0 - level.result.solution.H0, deeper / sloping.scales.thickness, 1e-7);
  const Scales& scales = sloping.scales;
  const FilmQuantities& film = sloping.result.quantities;
  EXPECT_NEAR(scales.thickness * film.central_film, 1.14709e-6, five_digits * 1.14709e-6);
  EXPECT_NEAR(scales.thickness * film.smallest_film, 0.95293e-6, five_digits * 0.95293e-6);
  EXPECT_NEAR(sloping.result.solution.H0, -4.277849, five_digits * 4.277849);
  // The pressure beyond the contact ends at the ends of the face, of which one is nearer: 0.7 in a thousand.
  const double moment = scales.force(sloping.face.tilting_moment) * scales.length;
  report("moment %.4f N m, force times shift %.4f N m", moment, face_load * shift);
  EXPECT_NEAR(moment, face_load * shift, 1e-3 * std::abs(face_load * shift));
  EXPECT_NEAR(moment, -6.99515, five_digits * 6.99515);
  EXPECT_NEAR(sloping.face.largest_pressure_at() * scales.length, shift, 0.5 * CrownedFilm::step);
}

// The middle of the face is so far from the ends that its row is a line contact under that row's own line load.
TEST(FaceFilm, is_in_the_middle_that_of_a_line_contact) {
  const SolvedFilm face = face_film(face_with(EndFace::half_space, relieved_ends()), 129, RowGrading{});
  const Scales& scales = face.film.scales();
  const FaceQuantities along = face_quantities(face.film);
  const std::size_t middle = along.Y.size() / 2;
  EXPECT_EQ(along.Y[middle], 0.0);
  const double line_load = along.line_load[middle] * scales.pressure * scales.length;
  const Scales of_line = line_scales(line_load);
  const double longer = scales.length / of_line.length;
  const SolvedFilm line(PETSC_COMM_SELF, of_line, {129, -3.0 * longer, 1.5 * longer, RowAxis::line()}, tight(),
                        central);
  EXPECT_GT(line_load, 1.05 * face_load / face_width);  // relieved ends carry less
  const FilmQuantities& alone = line.result.quantities;
  report("%.1f N/mm, central film %.5f um, line contact %.5f um; smallest %.5f, %.5f um", 1e-3 * line_load,
         1e6 * scales.thickness * along.central_film[middle], 1e6 * of_line.thickness * alone.central_film,
         1e6 * scales.thickness * along.smallest_film[middle], 1e6 * of_line.thickness * alone.smallest_film);
  const auto expect_near = [](double computed, double expected) { EXPECT_NEAR(computed, expected, 1e-4 * expected); };
  expect_near(scales.thickness * along.central_film[middle], of_line.thickness * alone.central_film);
  expect_near(scales.thickness * along.smallest_film[middle], of_line.thickness * alone.smallest_film);
  expect_near(scales.pressure * face.result.quantities.central_pressure, of_line.pressure * alone.central_pressure);
}

// The other program's corner is 0.36 +- 0.01 um, for the step of its rows in the end's stress; finer cells find it
// here.
TEST(FaceFilm, at_sharp_free_ends_is_that_of_another_program) {
  const SolvedFilm solved = face_film(face_with(EndFace::free), 65, {.first = 0.025});
  const RowAxis& rows = solved.grid.row_axis();
  EXPECT_NEAR(rows.step(rows.count() - 2), 0.03, 0.01 * 0.03);
  const double thickness = solved.film.scales().thickness;
  const FilmQuantities& film = solved.result.quantities;
  const FaceQuantities face = face_quantities(solved.film);
  report("%d rows: corner %.5f um, middle %.5f um, %d Newton and %d Krylov iterations", solved.grid.ny(),
         1e6 * thickness * face.corner_film(), 1e6 * thickness * film.central_film, solved.result.counts.newton,
         solved.result.counts.krylov);
  EXPECT_NEAR(thickness * face.corner_film(), 0.36e-6, 0.01e-6);
  EXPECT_GT(film.smallest_film, face.corner_film());  // of the rows between the corners
  EXPECT_NEAR(thickness * film.central_film, 1.27202e-6, 5e-4 * 1.27202e-6);
  EXPECT_EQ(face.smallest_film_at(), rows.whole_y(1));
  EXPECT_LE(solved.result.counts.krylov, 15 * solved.result.counts.newton);
}

TEST(MostLoadedPlace, is_where_a_face_carries_most_off_its_ends) {
  const auto place = [](const FaceGap& gap, double radius_y = HUGE_VAL) {
    const Scales scales = scales_of_solids({.radius_x = 9e-3,
                                            .radius_y = radius_y,
                                            .reduced_modulus = 226.3736e9,
                                            .face = std::make_shared<const Face>(face_with(EndFace::free, gap))},
                                           face_load);
    return scales.length * most_loaded_place(scales, scales.static_force, 1.0);
  };
  FaceGap tilted = relieved_ends();
  tilted.slope = 10e-6 / face_width;  // opens the end at +y, and the other one is relieved from -4 mm on
  EXPECT_NEAR(place(tilted), -4e-3, 1e-3);
  tilted.slope = -tilted.slope;
  EXPECT_NEAR(place(tilted), 4e-3, 1e-3);
  EXPECT_NEAR(place({}, 2.0), 0.0, 0.5e-3);
}

}  // namespace
}  // namespace gearfilm
