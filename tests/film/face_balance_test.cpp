// Conservation of mass over a whole face: what flows in flows out behind the contact or at the ends of the face.
#include "face_case.hpp"
#include "film/face_quantities.hpp"

namespace gearfilm {
namespace {

/// Flows of the central discretisation through the border of the inner nodes, from pressure and film anew; rows and
/// fields are whole.
class BorderFlows {
public:
  explicit BorderFlows(const SolvedFilm& solved)
      : grid_(solved.grid),
        pressure_(whole_of(solved.grid, solved.film.total_pressure())),
        film_(whole_of(solved.grid, solved.film.thickness())) {
    const Scales& scales = solved.film.scales();
    for (std::size_t n = 0; n < film_.size(); ++n) {
      const double p = scales.pressure * pressure_[n], rho = relative_density(scales.oil, p).value;
      mass_.push_back(rho * film_[n]);
      conductance_.push_back(mass_[n] * film_[n] * film_[n] * std::exp(-log_relative_viscosity(scales.oil, p).value) /
                             scales.lambda);
    }
  }

  int index(int i, int row) const { return i * grid_.rows() + row; }
  /// Width of the inner row's cell, its image not counted.
  double width(int row) const {
    const RowAxis& rows = grid_.row_axis();
    return 0.5 * (rows.y(row + 1) - rows.y(row - 1));
  }

  /// Behind the first line: both nodes' mean of rho H, and behind the last line but one its extrapolation.
  double in(int row) const {
    const int first = index(0, row), next = index(1, row);
    return width(row) * (0.5 * (mass_[first] + mass_[next]) - driven(first, next, grid_.h_x()));
  }
  double out(int row) const {
    const int i = grid_.nx() - 2, here = index(i, row), before = index(i - 1, row), last = index(i + 1, row);
    return width(row) * (1.5 * mass_[here] - 0.5 * mass_[before] - driven(here, last, grid_.h_x()));
  }
  /// Out of an end at a line.
  double aside(int i, bool upper) const {
    const int end = upper ? grid_.rows() - 1 : 0, inner = upper ? end - 1 : 1;
    const RowAxis& rows = grid_.row_axis();
    return -grid_.h_x() * driven(index(i, inner), index(i, end), std::abs(rows.y(end) - rows.y(inner)));
  }

private:
  /// By pressure against the direction from one node to another.
  double driven(int from, int to, double distance) const {
    return 0.5 * (conductance_[from] + conductance_[to]) * (pressure_[to] - pressure_[from]) / distance;
  }

  const Grid& grid_;
  std::vector<double> pressure_, film_, mass_, conductance_;
};

/// What the cells of cavitated inner nodes lack of their balance, and of full ones.
struct Lacking {
  double cavitated = 0.0, full = 0.0;
  int full_nodes = 0;
};

// A squeeze rate so negative that every inner node is full shows R itself, less that rate.
Lacking lacking_mass(SolvedFilm& solved) {
  const auto& [pressure, H0] = solved.result.solution;
  constexpr double suction = 1e6;
  const std::vector<double> sucking(pressure.size(), -suction);
  std::vector<double> rows(pressure.size());
  const Grid& grid = solved.grid;
  solved.film.residual(pressure, H0, {sucking}, rows);
  const std::vector<double> flows = whole_of(grid, rows), pressures = whole_of(grid, pressure);
  Lacking lacking;
  for (int i = 1; i < grid.nx() - 1; ++i) {
    for (int row = 1; row < grid.rows() - 1; ++row) {
      const int n = i * grid.rows() + row;
      const double cell = 0.5 * grid.h_x() * (grid.row_axis().y(row + 1) - grid.row_axis().y(row - 1));
      (pressures[n] == 0.0 ? lacking.cavitated : lacking.full) += cell * (flows[n] + suction);
      lacking.full_nodes += pressures[n] != 0.0;
    }
  }
  solved.film.evaluate(pressure, H0);
  return lacking;
}

// Equations of inner nodes telescope: what flows in flows out, or is what cavitated nodes are short of. What full nodes
// miss, Newton's method bounds; round-off of sums of 1e6 times their cells comes to it.
TEST(FaceBalance, of_a_misaligned_face_loses_no_oil) {
  const FaceGap gap = {.slope = 10e-6 / face_width, .reliefs = relieved_ends().reliefs};
  const Scales scales = face_scales(face_with(EndFace::half_space, gap));
  SolverOptions options;
  options.newton.tolerance = 1e-10;
  SolvedFilm solved(PETSC_COMM_WORLD, scales, shape_over(rows_of_face(scales, {}, Edge::ambient), 65), options,
                    FilmDiscretisation::central);
  const Grid& grid = solved.grid;
  const Lacking lacking = lacking_mass(solved);
  const BorderFlows flows(solved);
  double in = 0.0, out = 0.0, aside[2] = {0.0, 0.0}, beside[2] = {0.0, 0.0};
  for (int row = 1; row < grid.rows() - 1; ++row) {
    in += flows.in(row);
    out += flows.out(row);
  }
  for (int i = 1; i < grid.nx() - 1; ++i) {
    for (const bool upper : {false, true}) {
      aside[upper] += flows.aside(i, upper);
      if (grid.x(i) > -1.0) beside[upper] += flows.aside(i, upper);
    }
  }
  report("in %.6f, out %.6f, at the ends %.6f and %.6f, lacking in cavities %.6f, balance %.1e", in, out, aside[0],
         aside[1], lacking.cavitated, in - out - aside[0] - aside[1] + lacking.cavitated);
  EXPECT_NEAR(in + lacking.cavitated, out + aside[0] + aside[1], 1e-8 * in);
  EXPECT_NEAR(lacking.full, 0.0, 1e-8 * in);
  // Each must matter against what the balance may miss.
  EXPECT_GT(lacking.cavitated, 0.01 * in);
  EXPECT_GT(aside[0], 0.01);
  EXPECT_GT(aside[1], 1.5 * aside[0]);
  const FaceQuantities face = face_quantities(solved.film);
  EXPECT_NEAR(face.side_flow_lower, beside[0], 1e-10);
  EXPECT_NEAR(face.side_flow_upper, beside[1], 1e-10);
  double load = 0.0, moment = 0.0;
  for (int row = 1; row < grid.rows() - 1; ++row) {
    load += flows.width(row) * face.line_load[row];
    moment += flows.width(row) * face.line_load[row] * face.Y[row];
  }
  EXPECT_NEAR(load, scales.static_force, 1e-8 * scales.static_force);
  EXPECT_NEAR(face.tilting_moment, moment, 1e-10 * std::abs(moment));
  EXPECT_LT(moment, 0.0);
}

}  // namespace
}  // namespace gearfilm
