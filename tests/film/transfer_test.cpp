// Ghost rows, and the transfer of fields between a grid and its coarsening.
#include "film/transfer.hpp"

#include "film_case.hpp"

namespace gearfilm {
namespace {

/// Arithmetic, and along which directions the coarse grid is coarser.
template <class R, Coarsening c>
struct Kind {
  using Real = R;
  static constexpr Coarsening along = c;
};

template <class Kind>
class TransferOf : public testing::Test {
protected:
  using Number = typename Kind::Real;
  // Round-off of a dozen operations on values of order ten.
  static constexpr double tolerance = std::is_same_v<Number, double> ? 1e-13 : 1e-5;

  // Ones inside, zeros on the boundary and at every fifth node or so.
  static Field<Number> full_film_mask(const Grid& grid, unsigned seed) {
    Field<Number> full_film(grid);
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.y_count(); ++j) {
        full_film.row(i)[j] =
            !grid.is_boundary(i, j) && noise(i, grid.y_begin() + j, seed) > -0.6 ? Number(1) : Number(0);
      }
    }
    return full_film;
  }

  Grid fine{PETSC_COMM_WORLD, rectangle(33, 29, -2.0, 1.2, 1.5)};
  Grid coarse = fine.coarsened(Kind::along);
  Halo fine_halo{fine};
  Halo coarse_halo{coarse};
  Field<Number> on_fine{fine};
  Field<Number> on_coarse{coarse};
  Field<Number> all_wet_fine{fine};
  Field<Number> inner_coarse{coarse};

  TransferOf() {
    all_wet_fine.fill(Number(1));
    for (int i = 0; i < coarse.nx(); ++i) {
      for (int j = 0; j < coarse.y_count(); ++j)
        inner_coarse.row(i)[j] = coarse.is_boundary(i, j) ? Number(0) : Number(1);
    }
  }
};
using Kinds = testing::Types<Kind<float, Coarsening::both>, Kind<double, Coarsening::both>,
                             Kind<double, Coarsening::x_only>, Kind<double, Coarsening::y_only>>;
TYPED_TEST_SUITE(TransferOf, Kinds);

TYPED_TEST(TransferOf, coarse_nodes_are_every_second_one_along_the_directions_asked_for) {
  const Grid &from = this->fine, &to = this->coarse;
  EXPECT_EQ(to.nx(), TypeParam::along == Coarsening::y_only ? 33 : 17);
  EXPECT_EQ(to.ny(), TypeParam::along == Coarsening::x_only ? 29 : 15);
  EXPECT_DOUBLE_EQ(to.x(to.nx() - 1), from.x(from.nx() - 1));
  EXPECT_DOUBLE_EQ(to.h_y() * (to.rows() - 1), from.h_y() * (from.rows() - 1));
}

TYPED_TEST(TransferOf, ghosts_are_the_rows_of_the_neighbours_or_the_mirror_image) {
  using Real = typename TypeParam::Real;
  const Grid& grid = this->fine;
  const auto number = [](int i, int row) { return static_cast<Real>(1000 * (i + 1) + row + 1); };
  Field<Real>& field = this->on_fine;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) field.row(i)[j] = number(i, grid.y_begin() + j);
  }
  this->fine_halo.exchange(field);
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = -1; j <= grid.y_count(); ++j) {
      const int row = grid.y_begin() + j;
      EXPECT_EQ(field.row(i)[j], row == grid.rows() ? Real(0) : number(i, std::abs(row))) << i << ' ' << row;
    }
  }
}

TYPED_TEST(TransferOf, full_weighting_keeps_constants) {
  using Real = typename TypeParam::Real;
  this->on_fine.fill(Real(0));
  fill(this->fine, this->on_fine, [](double, double) { return 3.25; });
  this->fine_halo.exchange(this->on_fine);
  restrict_residual(this->fine, this->coarse, this->on_fine, this->inner_coarse, this->on_coarse);
  for (int i = 0; i < this->coarse.nx(); ++i) {
    for (int j = 0; j < this->coarse.y_count(); ++j) {
      EXPECT_EQ(this->on_coarse.row(i)[j], this->coarse.is_boundary(i, j) ? Real(0) : Real(3.25));
    }
  }
}

TYPED_TEST(TransferOf, full_weighting_is_zero_where_nothing_flows) {
  using Real = typename TypeParam::Real;
  const auto full_film = this->full_film_mask(this->coarse, 1);
  fill(this->fine, this->on_fine, [](double x, double) { return 3.0 + x; });
  this->fine_halo.exchange(this->on_fine);
  restrict_residual(this->fine, this->coarse, this->on_fine, full_film, this->on_coarse);
  for (int i = 0; i < this->coarse.nx(); ++i) {
    for (int j = 0; j < this->coarse.y_count(); ++j) {
      EXPECT_EQ(this->on_coarse.row(i)[j] == Real(0), full_film.row(i)[j] == 0.0);
    }
  }
}

TYPED_TEST(TransferOf, bilinear_interpolation_is_exact_for_bilinear_fields) {
  using Real = typename TypeParam::Real;
  const auto plane = [](double x, double y) { return 0.5 + 2.0 * x - 3.0 * y + 0.25 * x * y; };
  fill(this->coarse, this->on_coarse, plane);
  this->coarse_halo.exchange(this->on_coarse);
  this->on_fine.fill(Real(1));
  add_interpolated(this->coarse, this->fine, this->on_coarse, this->all_wet_fine, this->on_fine);
  for (int i = 1; i < this->fine.nx() - 1; ++i) {
    for (int j = 0; j < this->fine.y_count(); ++j) {
      EXPECT_NEAR(this->on_fine.row(i)[j], 1.0 + plane(this->fine.x(i), this->fine.y(j)), TestFixture::tolerance);
    }
  }
}

TYPED_TEST(TransferOf, interpolation_leaves_nodes_alone_that_are_not_wet) {
  using Real = typename TypeParam::Real;
  const auto full_film = this->full_film_mask(this->fine, 2);
  this->on_coarse.fill(Real(7));
  this->on_fine.fill(Real(-2));
  add_interpolated(this->coarse, this->fine, this->on_coarse, full_film, this->on_fine);
  for (int i = 0; i < this->fine.nx(); ++i) {
    for (int j = 0; j < this->fine.y_count(); ++j) {
      EXPECT_NEAR(this->on_fine.row(i)[j], full_film.row(i)[j] != 0.0 ? 5.0 : -2.0, TestFixture::tolerance);
    }
  }
}

// Sum over coarse nodes of c R f = sum over fine nodes of f I c, over the fine nodes that a coarse one stands for, with
// masked f and c: what a symmetric cycle needs.
TYPED_TEST(TransferOf, full_weighting_is_the_transpose_of_interpolation_in_part) {
  using Real = typename TypeParam::Real;
  const auto wet_fine = this->full_film_mask(this->fine, 3), wet_coarse = this->full_film_mask(this->coarse, 4);
  Field<Real> restricted(this->coarse), interpolated(this->fine);
  for (int i = 0; i < this->fine.nx(); ++i) {
    for (int j = 0; j < this->fine.y_count(); ++j) {
      this->on_fine.row(i)[j] = static_cast<Real>(wet_fine.row(i)[j] * noise(i, this->fine.y_begin() + j, 5));
    }
  }
  for (int i = 0; i < this->coarse.nx(); ++i) {
    for (int j = 0; j < this->coarse.y_count(); ++j) {
      this->on_coarse.row(i)[j] = static_cast<Real>(wet_coarse.row(i)[j] * noise(i, this->coarse.y_begin() + j, 6));
    }
  }
  this->fine_halo.exchange(this->on_fine);
  this->coarse_halo.exchange(this->on_coarse);
  restrict_residual(this->fine, this->coarse, this->on_fine, wet_coarse, restricted);
  add_interpolated(this->coarse, this->fine, this->on_coarse, wet_fine, interpolated);
  const auto halves = [](const Grid& grid, int j) { return grid.y_begin() + j == 0 ? 1.0 : 2.0; };
  const double part = TypeParam::along == Coarsening::both ? 0.25 : 0.5;
  double sums[2] = {0.0, 0.0};
  for (int i = 0; i < this->coarse.nx(); ++i) {
    for (int j = 0; j < this->coarse.y_count(); ++j) {
      sums[0] += halves(this->coarse, j) * this->on_coarse.row(i)[j] * restricted.row(i)[j];
    }
  }
  for (int i = 0; i < this->fine.nx(); ++i) {
    for (int j = 0; j < this->fine.y_count(); ++j) {
      sums[1] += part * halves(this->fine, j) * this->on_fine.row(i)[j] * interpolated.row(i)[j];
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  EXPECT_NEAR(sums[0], sums[1], TestFixture::tolerance);
  EXPECT_GT(std::abs(sums[0]), 0.01);
}

class CubicInterpolation : public testing::Test {
protected:
  /// From this fine row on nothing is taken from across Y = 0.
  static constexpr int one_side = 2;

  /// Largest error at nodes at least `margin` coarse cells from the edges, from a row on.
  template <class Function>
  double error_for(Function f, int margin, int first_row = 0) {
    return error_from(coarse, f, margin, first_row);
  }

  template <class Function>
  double error_from(const Grid& before, Function f, int margin, int first_row = 0) {
    Field<double> on_fine(fine), on_coarse(before);
    fill(before, on_coarse, f);
    interpolate_cubic(before, fine, on_coarse, on_fine);
    double error = 0.0;
    for (int i = 2 * margin; i < fine.nx() - 2 * margin; ++i) {
      for (int j = 0; j < fine.y_count(); ++j) {
        const int row = fine.y_begin() + j;
        if (row < first_row || row >= fine.rows() - 2 * margin) continue;
        error = std::max(error, std::abs(on_fine.row(i)[j] - f(fine.x(i), fine.y(j))));
      }
    }
    return maximum(error);
  }

  Grid fine{PETSC_COMM_WORLD, rectangle(33, 29, -2.0, 1.2, 1.5)};
  Grid coarse = fine.coarsened();
  static constexpr double round_off = 1e-13;  // a dozen operations on values of order ten
};

TEST_F(CubicInterpolation, is_exact_for_cubics_away_from_the_edges) {
  const auto cubic = [](double t) { return 1.0 - t + 0.5 * t * t - 2.0 * t * t * t; };
  EXPECT_LT(error_for([&](double x, double y) { return cubic(x) * cubic(0.7 * y); }, 1, one_side), round_off);
  EXPECT_LT(error_for([&](double x, double y) { return cubic(x) * (1.0 - 0.7 * y * y); }, 1), round_off);
  EXPECT_GT(error_for([](double x, double) { return x * x * x * x; }, 1), 1e-6);
}

TEST_F(CubicInterpolation, is_exact_for_bilinear_fields_everywhere) {
  EXPECT_LT(error_for([](double x, double y) { return 1.0 + 2.0 * x - y + 3.0 * x * y; }, 0, one_side), round_off);
  EXPECT_LT(error_for([](double x, double) { return 1.0 + 2.0 * x; }, 0), round_off);
}

// Not a polynomial across: nothing is interpolated there.
TEST_F(CubicInterpolation, leaves_lines_alone_that_the_coarse_grid_has_all) {
  const Grid all_rows = fine.coarsened(Coarsening::x_only);
  EXPECT_EQ(all_rows.nx(), coarse.nx());
  EXPECT_EQ(all_rows.rows(), fine.rows());
  const auto cubic = [](double t) { return 1.0 - t + 0.5 * t * t - 2.0 * t * t * t; };
  const auto rough = [](double y) { return std::sin(40.0 * y); };
  EXPECT_LT(error_from(
                all_rows, [&](double x, double y) { return cubic(x) * rough(y); }, 1),
            round_off);
  EXPECT_GT(error_from(
                coarse, [&](double x, double y) { return cubic(x) * rough(y); }, 1),
            1e-3);
}

TEST(InjectedState, takes_every_field_at_the_same_point) {
  const Grid fine(PETSC_COMM_WORLD, rectangle(33, 29, -2.0, 1.2, 1.5));
  const Grid coarse = fine.coarsened();
  FilmState fine_state(fine);
  const auto value = [](std::size_t n, double x, double y) { return n + 1.0 + 0.3 * x - 0.2 * y; };
  for (std::size_t n = 0; n < state_fields.size(); ++n) {
    fill(fine, fine_state.*state_fields[n], [&](double x, double y) { return value(n, x, y); });
  }
  const FilmState coarse_state = injected_state(fine, coarse, Halo(coarse), fine_state);
  for (std::size_t n = 0; n < state_fields.size(); ++n) {
    for (int i = 0; i < coarse.nx(); ++i) {
      for (int j = 0; j < coarse.y_count(); ++j) {
        // Coordinates of one point on two grids differ by round-off.
        EXPECT_NEAR((coarse_state.*state_fields[n]).row(i)[j], value(n, coarse.x(i), coarse.y(j)), 1e-14);
      }
    }
  }
}

}  // namespace
}  // namespace gearfilm
