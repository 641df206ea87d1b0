// Stresses in sections below films: Hertz contacts, sections and whole fields, processes; what passes over a flank.
#include "stress/row_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "damage_reference.hpp"
#include "fatigue/dang_van.hpp"
#include "fatigue/flank_map.hpp"
#include "stress/largest_stresses.hpp"
#include "stress/stress_field.hpp"

namespace gearfilm {
namespace {

using Load = std::function<double(double x, double y)>;

constexpr std::array<double, body_count> steel{0.3, 0.3};

Grid line_grid(int nx) { return {MPI_COMM_SELF, {nx, -1.25, 1.25, RowAxis::line()}}; }

std::vector<double> on_grid(const Grid& grid, const Load& load) {
  std::vector<double> values;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) values.push_back(load(grid.x(i), grid.y(j)));
  }
  return values;
}

/// Hertz pressure of the half-axes 1 and b.
Load hertz(double b) {
  return [b](double x, double y) { return std::sqrt(std::max(0.0, 1.0 - x * x - y * y / (b * b))); };
}

/// Of a pressure and shear that is mu times it: along +x on the pinion, -x on the wheel.
SurfaceLoads loads_of(const Grid& grid, const Load& pressure, double mu = 0.0) {
  SurfaceLoads loads;
  loads.pressure = on_grid(grid, pressure);
  for (const double p : loads.pressure) {
    loads.shear[pinion_body].push_back(mu * p);
    loads.shear[wheel_body].push_back(-mu * p);
  }
  return loads;
}

RowStress central_row(const Grid& grid, const std::vector<double>& depths, double reach = 2.5) {
  return {grid, {.rows = {grid.row_axis().central()}, .depths = depths, .poisson_ratio = steel, .reach = reach}};
}

LargestStresses figures_of(const Grid& grid, const SurfaceLoads& loads) {
  RowStress row = central_row(grid, stress_depths(2.0, 24));
  return largest_stresses(stress_profiles(row, row.evaluate(loads).front())[pinion_body], row.depths());
}

// Between depths a parabola: 1e-3.
TEST(SectionStress, of_a_line_contact_is_hertz_s) {
  const Grid grid = line_grid(129);
  const LargestStresses found = figures_of(grid, loads_of(grid, hertz(1.0)));
  EXPECT_NEAR(found.von_mises.value, damage_number("line_von_mises_max_nu.3"), 2e-3);
  EXPECT_NEAR(found.von_mises.at, damage_number("line_von_mises_depth"), 0.02);
  EXPECT_NEAR(found.largest_shear.value, damage_number("line_tau_max"), 2e-3);
  EXPECT_NEAR(found.largest_shear.at, damage_number("line_tau_max_depth"), 0.02);
  EXPECT_NEAR(found.orthogonal_shear.value, 0.25, 2e-3);
  EXPECT_NEAR(found.orthogonal_shear.at, 0.5, 0.02);
  EXPECT_LT(found.surface_tension, 1e-3);
}

TEST(SectionStress, of_a_line_contact_is_the_closed_form_everywhere) {
  const Grid grid = line_grid(257);
  RowStress row = central_row(grid, {0.3, 0.8, 1.6});
  const SectionStress& found = row.evaluate(loads_of(grid, hertz(1.0))).front()[pinion_body];
  for (int depth = 0; depth < found.depths(); ++depth) {
    for (int line = 0; line < found.lines(); ++line) {
      const Stress exact = line_contact_stress(row.lines().x(line), row.depths()[depth]), near = found.at(depth, line);
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(near.components()[c], exact.components()[c], 1e-3) << line;
    }
  }
}

TEST(SectionStress, of_a_sliding_line_contact_has_the_numbers_of_the_reference) {
  const Grid grid = line_grid(257);
  for (const auto& [mu, name] :
       {std::pair{0.05, "line_von_mises_mu0.05"}, {0.1, "line_von_mises_mu0.10"}, {0.2, "line_von_mises_mu0.20"}}) {
    EXPECT_NEAR(figures_of(grid, loads_of(grid, hertz(1.0), mu)).von_mises.value, damage_number(name), 2e-3) << mu;
  }
}

TEST(SectionStress, of_circular_and_elliptical_contacts_is_hertz_s) {
  const Grid circle(MPI_COMM_WORLD, rectangle(129, 129, -1.25, 1.25, 1.25));
  const LargestStresses found = figures_of(circle, loads_of(circle, hertz(1.0)));
  EXPECT_NEAR(found.von_mises.value, damage_number("circle_von_mises_max_nu.3"), 1e-3);
  EXPECT_NEAR(found.von_mises.at, damage_number("circle_von_mises_depth"), 0.02);
  RowStress at_maximum = central_row(circle, {damage_number("circle_von_mises_depth")});
  const StressProfiles there = stress_profiles(at_maximum, at_maximum.evaluate(loads_of(circle, hertz(1.0))).front());
  EXPECT_NEAR(there[pinion_body].von_mises.front(), damage_number("circle_von_mises_max_nu.3"), 5e-4);
  for (const double ratio : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double b = 1.0 / ratio;
    const Grid grid(MPI_COMM_WORLD, rectangle(65, 65, -1.25, 1.25, 1.25 * b));
    const std::string name = "johnson_tau1_a_over_b_" + std::to_string(ratio).substr(0, 3);
    EXPECT_NEAR(figures_of(grid, loads_of(grid, hertz(b))).largest_shear.value, damage_number(name), 2e-3) << name;
  }
  const Grid grid(MPI_COMM_WORLD, rectangle(129, 129, -1.25, 1.25, 1.25 * 2.5));
  RowStress surface = central_row(grid, {0.0});
  const SectionStress& section = surface.evaluate(loads_of(grid, hertz(2.5))).front()[pinion_body];
  if (section.depths() == 0) return;  // on another process
  const int middle = surface.lines().before + 64;
  EXPECT_NEAR(section.at(0, middle).xx, damage_number("ellipse_b2.5_surface_centre_xx"), 2e-3);
  EXPECT_NEAR(section.at(0, middle).yy, damage_number("ellipse_b2.5_surface_centre_yy"), 2e-3);
}

TEST(SectionStress, of_the_surface_is_the_load) {
  const Grid grid = line_grid(257);
  const SurfaceLoads loads = loads_of(grid, hertz(1.0), 0.2);
  RowStress row = central_row(grid, {0.0});
  const SectionStresses& sections = row.evaluate(loads).front();
  double tension = 0.0;
  for (int line = 0; line < sections[pinion_body].lines(); ++line) {
    const int i = line - row.lines().before;
    const bool on = i >= 0 && i < grid.nx();
    for (std::size_t body = 0; body < body_count; ++body) {
      const Stress found = sections[body].at(0, line);
      EXPECT_NEAR(found.zz, on ? -loads.pressure[i] : 0.0, 1e-10);
      EXPECT_NEAR(found.xz, on ? -loads.shear[body][i] : 0.0, 1e-10);
    }
    if (row.lines().x(line) < 0.0) tension = std::max(tension, sections[pinion_body].at(0, line).xx);
  }
  // 2 mu p_h at the trailing edge, which a grid does not resolve.
  EXPECT_NEAR(tension, 0.4, 0.15 * 0.4);
}

/// A load that has no symmetry along x.
double skewed(double x, double y) { return (1.0 + 0.5 * x) * hertz(3.0)(x + 0.1, y); }

TEST(SectionStress, is_mirrored_where_shear_is_turned) {
  const Grid grid(MPI_COMM_WORLD, rectangle(33, 17, -1.5, 1.5, 4.0));
  RowStress row = central_row(grid, {0.0, 0.3, 1.0, 2.0, 2.5});
  const SectionStresses forward = row.evaluate(loads_of(grid, hertz(3.0), 0.1)).front();
  const SectionStresses backward = row.evaluate(loads_of(grid, hertz(3.0), -0.1)).front();
  const int last = forward[0].lines() - 1;
  for (int depth = 0; depth < forward[0].depths(); ++depth) {
    for (int line = 0; line <= last; ++line) {
      const Stress a = forward[pinion_body].at(depth, line), b = backward[pinion_body].at(depth, last - line),
                   other = backward[wheel_body].at(depth, line);
      EXPECT_NEAR(a.xx, b.xx, 1e-12);
      EXPECT_NEAR(a.zz, b.zz, 1e-12);
      EXPECT_NEAR(a.xz, -b.xz, 1e-12);
      // What the pinion feels before the pitch point the wheel of equal gears feels behind it.
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(a.components()[c], other.components()[c], 1e-12);
    }
  }
}

/// Largest difference of a section of two computations, each on the processes of its grid.
TEST(SectionStress, is_the_same_on_any_number_of_processes) {
  const GridShape shape = rectangle(33, 17, -2.0, 1.25, 4.0);
  const Grid whole(MPI_COMM_SELF, shape), cut(MPI_COMM_WORLD, shape);
  const std::vector<double> depths = stress_depths(2.0, 9);
  RowStress alone = central_row(whole, depths), together = central_row(cut, depths);
  const SectionStresses expected = alone.evaluate(loads_of(whole, skewed, 0.1)).front();
  const SectionStresses found = together.evaluate(loads_of(cut, skewed, 0.1)).front();
  const RowRange own = together.own_depths();
  for (int depth = own.begin; depth < own.end; ++depth) {
    for (int line = 0; line < found[0].lines(); ++line) {
      for (std::size_t c = 0; c < 6; ++c) {
        EXPECT_NEAR(found[wheel_body].line_of(depth - own.begin, c)[line], expected[wheel_body].line_of(depth, c)[line],
                    1e-13);
      }
    }
  }
  const StressProfiles a = stress_profiles(alone, expected), b = stress_profiles(together, found);
  for (std::size_t k = 0; k < depths.size(); ++k) {
    EXPECT_NEAR(a[wheel_body].von_mises[k], b[wheel_body].von_mises[k], 1e-13);
    EXPECT_NEAR(a[wheel_body].orthogonal_shear[k], b[wheel_body].orthogonal_shear[k], 1e-13);
  }
}

void expect_field_to_have_sections(const Grid& grid, const std::vector<int>& rows, double z,
                                   const std::array<double, body_count>& ratio) {
  const SurfaceLoads loads = loads_of(grid, skewed, 0.1);
  RowStress below(grid, {.rows = rows, .depths = {z}, .poisson_ratio = ratio, .reach = 0.0});
  const std::vector<SectionStresses>& found = below.evaluate(loads);
  const auto field = stress_field(grid, loads, z, ratio);
  ASSERT_EQ(found.size(), rows.size());
  for (std::size_t n = 0; n < rows.size(); ++n) {
    // The section's one depth on all processes.
    std::vector<double> values(body_count * grid.nx() * stress_components, 0.0);
    for (std::size_t body = 0; body < body_count && found[n][0].depths() > 0; ++body) {
      for (int i = 0; i < grid.nx(); ++i) {
        for (std::size_t c = 0; c < stress_components; ++c) {
          values[(body * grid.nx() + i) * stress_components + c] = found[n][body].line_of(0, c)[i];
        }
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM, grid.comm());
    const int own = grid.local_row(rows[n]);
    for (std::size_t body = 0; body < body_count && own >= 0; ++body) {
      for (int i = 0; i < grid.nx(); ++i) {
        const auto components = field[body][i * grid.y_count() + own].components();
        for (std::size_t c = 0; c < stress_components; ++c) {
          EXPECT_NEAR(components[c], values[(body * grid.nx() + i) * stress_components + c], 1e-13) << i << ' ' << c;
        }
      }
    }
  }
}

TEST(StressField, has_the_sections_in_its_rows) {
  const Grid grid(MPI_COMM_WORLD, rectangle(33, 17, -2.0, 1.25, 4.0));
  const Grid graded(
      MPI_COMM_WORLD,
      {33, -2.0, 1.25, RowAxis({-4.0, -3.8, -3.0, -1.5, 0.0, 1.5, 3.0, 3.8, 4.0}, Edge::ambient, Edge::ambient)});
  for (const double z : {0.0, 0.6}) {
    expect_field_to_have_sections(grid, {0}, z, steel);
    expect_field_to_have_sections(grid, {0, 5}, z, {0.3, 0.25});
    expect_field_to_have_sections(graded, {1, 4, 6}, z, steel);
  }
}

// Loads are constant on cells: from about the distance of rows on, here 0.45, the depth does not know them.
TEST(SectionStress, below_graded_rows_is_that_below_equal_ones) {
  const Load smooth = [](double x, double y) { return std::exp(-2.0 * x * x - 0.25 * y * y); };
  const Grid equal(MPI_COMM_SELF, rectangle(65, 161, -2.0, 2.0, 4.0)),
      graded(
          MPI_COMM_SELF,
          {65, -2.0, 2.0, RowAxis({0.0, 0.3, 0.6, 0.9, 1.3, 1.8, 2.4, 3.0, 3.5, 4.0}, Edge::symmetry, Edge::ambient)});
  const std::vector<double> depths{0.5, 0.8, 1.2};
  RowStress fine(equal, {.rows = {26}, .depths = depths, .poisson_ratio = steel}),
      coarse(graded, {.rows = {4}, .depths = depths, .poisson_ratio = steel});
  ASSERT_NEAR(equal.row_axis().y(26), 1.3, 1e-12);
  const SectionStress& expected = fine.evaluate(loads_of(equal, smooth, 0.1)).front()[pinion_body];
  const SectionStress& found = coarse.evaluate(loads_of(graded, smooth, 0.1)).front()[pinion_body];
  for (int depth = 0; depth < found.depths(); ++depth) {
    for (int line = 0; line < found.lines(); ++line) {
      const auto a = found.at(depth, line).components(), b = expected.at(depth, line).components();
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(a[c], b[c], 5e-3) << depth << ' ' << line << ' ' << c;
    }
  }
}

// Half of the rows are stored where they are mirrored.
TEST(StressField, of_half_the_rows_is_that_of_all) {
  const Grid half(MPI_COMM_SELF, rectangle(33, 17, -2.0, 1.25, 4.0)),
      all(MPI_COMM_SELF, rectangle(33, 17, -2.0, 1.25, 4.0, Edge::ambient));
  const auto of_half = stress_field(half, loads_of(half, skewed, 0.1), 0.5, steel),
             of_all = stress_field(all, loads_of(all, skewed, 0.1), 0.5, steel);
  for (int i = 0; i < half.nx(); ++i) {
    for (int j = 0; j < half.y_count(); ++j) {
      const auto a = of_half[0][i * half.y_count() + j].components(),
                 b = of_all[0][i * all.y_count() + 8 + j].components();
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(a[c], b[c], 1e-13) << i << ' ' << j;
    }
  }
}

/// The section at one depth as a history with the unloaded state.
std::vector<Stress> frozen(const SectionStress& section, int depth) {
  std::vector<Stress> history{{}};
  for (int line = 0; line < section.lines(); ++line) history.push_back(section.at(depth, line));
  history.emplace_back();
  return history;
}

TEST(DangVan, of_a_sliding_line_contact_has_the_number_of_the_reference) {
  const Grid grid = line_grid(257);
  std::vector<double> depths;
  for (double z = 0.4; z < 0.75; z += 0.02) depths.push_back(z);
  RowStress row = central_row(grid, depths);
  const SectionStress& section = row.evaluate(loads_of(grid, hertz(1.0), 0.1)).front()[pinion_body];
  double largest = 0.0;
  for (int depth = 0; depth < section.depths(); ++depth) {
    largest = std::max(largest, dang_van(frozen(section, depth), {.alpha = 0.3}));
  }
  EXPECT_NEAR(largest, damage_number("dv_line_alpha.3_mu.1_max"), 0.01 * largest);
}

LineOfAction some_gears() {
  SpurGearPair pair;
  pair.module_length = 3e-3;
  pair.pressure_angle = std::numbers::pi / 9.0;
  pair.centre_distance = 0.081;
  pair.face_width = 0.02;
  pair.pinion = {.teeth = 28, .outer_radius = 45.0e-3, .youngs_modulus = 206e9, .poisson_ratio = 0.3};
  pair.wheel = {.teeth = 26, .outer_radius = 42.0e-3, .youngs_modulus = 206e9, .poisson_ratio = 0.3};
  return LineOfAction(pair);
}

// A contact of constant half-width a = 0.2 mm under a constant pressure.
TEST(FlankHistory, of_a_constant_contact_is_its_section) {
  constexpr double a = 2e-4, pressure = 1.5e9;
  const Grid grid = line_grid(129);
  RowStress row = central_row(grid, {0.5, 0.7});
  const SectionStresses& sections = row.evaluate(loads_of(grid, hertz(1.0), 0.05)).front();
  const SectionPlaces places{a * row.lines().first, a * row.lines().step, row.lines().count};
  const LineOfAction line = some_gears();
  for (const std::size_t body : {pinion_body, wheel_body}) {
    FlankHistory history(FlankPath(line, body == pinion_body));
    // Steps of up to 0.05 a of the material, the later half first.
    for (double xi = 0.0; xi < 2e-3; xi += 0.04 * a)
      history.add(section_record(xi, places, sections[body], pressure, true));
    for (double xi = -0.04 * a; xi > -2e-3; xi -= 0.04 * a) {
      history.add(section_record(xi, places, sections[body], pressure, true));
    }
    const std::vector<double> at{history.path().arc_length(0.0)};
    const FlankMap map = flank_map(history, at, 2, {.alpha = 0.3});
    for (int depth = 0; depth < 2; ++depth) {
      const double expected = pressure * dang_van(frozen(sections[body], depth), {.alpha = 0.3});
      EXPECT_NEAR(map.dang_van[depth], expected, 5e-3 * expected);
      double equivalent = 0.0;
      for (const Stress& stress : frozen(sections[body], depth)) equivalent = std::max(equivalent, von_mises(stress));
      EXPECT_NEAR(map.von_mises[depth], pressure * equivalent, 5e-3 * pressure * equivalent);
    }
  }
}

// Kept in single precision.
TEST(FlankHistory, needs_no_more_of_sections_than_its_points) {
  constexpr double a = 2e-4;
  const Grid grid = line_grid(65);
  RowStress row = central_row(grid, {0.5, 0.7});
  const SectionStresses& sections = row.evaluate(loads_of(grid, hertz(1.0), 0.05)).front();
  const SectionPlaces places{a * row.lines().first, a * row.lines().step, row.lines().count};
  const LineOfAction line = some_gears();
  for (const std::size_t body : {pinion_body, wheel_body}) {
    const FlankPath path(line, body == pinion_body);
    const std::vector<double> points = flank_points(path, 41);
    FlankHistory whole(path), thinned(path);
    for (double xi = line.entry(); xi < line.exit(); xi += 0.1 * a) {
      const SectionRecord section = section_record(xi, places, sections[body], 1.0, true);
      const SectionRecord kept = at_points(section, path, points);
      EXPECT_LT(kept.values.size(), section.values.size() / 5);
      whole.add(section);
      thinned.add(kept);
    }
    const FlankMap expected = flank_map(whole, points, 2, {.alpha = 0.3}),
                   found = flank_map(thinned, points, 2, {.alpha = 0.3});
    for (std::size_t n = 0; n < expected.dang_van.size(); ++n) {
      EXPECT_NEAR(found.dang_van[n], expected.dang_van[n], 1e-6) << n;
      EXPECT_NEAR(found.von_mises[n], expected.von_mises[n], 1e-6) << n;
      EXPECT_NEAR(found.orthogonal_amplitude[n], expected.orthogonal_amplitude[n], 1e-6) << n;
    }
  }
}

// Two passing waves of load: the point at the pitch feels the most when the contact's middle is there.
TEST(FlankHistory, of_a_point_at_the_pitch_is_largest_while_the_contact_is_there) {
  constexpr double a = 2e-4;
  const Grid grid = line_grid(129);
  RowStress row = central_row(grid, {0.7});
  const SectionStresses& sections = row.evaluate(loads_of(grid, hertz(1.0))).front();
  const SectionPlaces places{a * row.lines().first, a * row.lines().step, row.lines().count};
  const FlankPath path(some_gears(), true);
  double largest = 0.0, at = 1.0;
  for (double xi = -1e-3; xi < 1e-3; xi += 0.05 * a) {
    const SectionRecord record = section_record(xi, places, sections[pinion_body], 1.0, true);
    const double equivalent = von_mises(record.at(0, path.place(path.arc_length(0.0), xi)));
    if (equivalent > largest) {
      largest = equivalent;
      at = xi;
    }
  }
  EXPECT_NEAR(at, 0.0, 0.05 * a);
  EXPECT_NEAR(largest, von_mises(line_contact_stress(0.0, 0.7)), 2e-3);
}

TEST(SurfaceLoads, of_both_bodies_are_the_forces_on_the_film) {
  const Grid grid(MPI_COMM_WORLD, rectangle(33, 17, -2.0, 1.25, 4.0));
  const std::vector<double> pressure = on_grid(grid, skewed), shear = on_grid(grid, hertz(2.0)),
                            thickness(pressure.size(), 1e-3);
  const SurfaceLoads loads = surface_loads(grid, {pressure, pressure}, thickness, shear);
  const std::size_t rows = grid.y_count();
  for (std::size_t n = rows; n + rows < pressure.size(); ++n) {
    const double slope = (pressure[n + rows] - pressure[n - rows]) / (2.0 * grid.h_x());
    EXPECT_NEAR(loads.shear[pinion_body][n] + loads.shear[wheel_body][n], -2.0 * 1e-3 * slope, 1e-15);
    EXPECT_NEAR(loads.shear[wheel_body][n] - loads.shear[pinion_body][n], 2.0 * shear[n], 1e-15);
  }
}

}  // namespace
}  // namespace gearfilm
