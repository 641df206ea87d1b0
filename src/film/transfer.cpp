#include "film/transfer.hpp"

namespace gearfilm {
namespace {

/// Fine cells in a coarse one along either direction, 1 or 2.
struct Ratio {
  Ratio(const Grid& fine, const Grid& coarse)
      : x(coarse.nx() == fine.nx() ? 1 : 2), y(coarse.rows() == fine.rows() ? 1 : 2) {}

  int x, y;
};

/// Of a mean of three fine nodes at a coarse one: those on either side, and the one at the same place.
template <class Real>
struct Weighting {
  explicit Weighting(int ratio) : side(ratio == 1 ? Real(0) : Real(0.25)), centre(ratio == 1 ? Real(1) : Real(0.5)) {}

  Real side, centre;
};

/// Local fine row at the place of the local coarse row J.
int same_row(const Grid& fine_grid, const Grid& coarse_grid, int ratio, int J) {
  return ratio * (coarse_grid.y_begin() + J) - fine_grid.y_begin();
}

}  // namespace

int injected_row(const Grid& fine_grid, const Grid& coarse_grid, int J) {
  return same_row(fine_grid, coarse_grid, Ratio(fine_grid, coarse_grid).y, J);
}

template <class Real>
void restrict_residual(const Grid& fine_grid, const Grid& coarse_grid, const Field<Real>& fine,
                       const Field<Real>& coarse_full_film, Field<Real>& coarse) {
  const Ratio ratio(fine_grid, coarse_grid);
  const Weighting<Real> along_x(ratio.x), along_y(ratio.y);
  const Real side = along_x.side, centre = along_x.centre;
  for (int I = 1; I < coarse_grid.nx() - 1; ++I) {
    const Real* before = fine.row(ratio.x * I - 1);
    const Real* here = fine.row(ratio.x * I);
    const Real* after = fine.row(ratio.x * I + 1);
    const auto mean = [&](int j) { return side * (before[j] + after[j]) + centre * here[j]; };
    const Real* full_film = coarse_full_film.row(I);
    Real* out = coarse.row(I);
    for (int J = 0; J < coarse_grid.y_count(); ++J) {
      const int j = same_row(fine_grid, coarse_grid, ratio.y, J);
      out[J] = full_film[J] * (along_y.side * (mean(j - 1) + mean(j + 1)) + along_y.centre * mean(j));
    }
  }
}

template <class Real>
void add_interpolated(const Grid& coarse_grid, const Grid& fine_grid, const Field<Real>& coarse,
                      const Field<Real>& fine_full_film, Field<Real>& fine) {
  const Ratio ratio(fine_grid, coarse_grid);
  for (int i = 1; i < fine_grid.nx() - 1; ++i) {
    const Real* below = coarse.row(i / ratio.x);
    const Real* above = coarse.row((i + ratio.x - 1) / ratio.x);
    const Real* full_film = fine_full_film.row(i);
    Real* out = fine.row(i);
    for (int j = 0; j < fine_grid.y_count(); ++j) {
      const int row = fine_grid.y_begin() + j;
      const int J = row / ratio.y - coarse_grid.y_begin();
      const int J_next = (row + ratio.y - 1) / ratio.y - coarse_grid.y_begin();
      out[j] += full_film[j] * Real(0.25) * (below[J] + below[J_next] + above[J] + above[J_next]);
    }
  }
}

// Midway between two nodes the cubic through four is the mean less a sixteenth of the two second differences: second
// differences travel between processes with a single ghost row.
void interpolate_cubic(const Grid& coarse_grid, const Grid& fine_grid, const Field<double>& coarse,
                       Field<double>& fine) {
  const Halo halo(coarse_grid);
  Field<double> values(coarse), bend_x(coarse_grid), bend_y(coarse_grid), bend_xy(coarse_grid);
  halo.exchange(values);
  const RowRange inner = coarse_grid.inner_rows();
  const Ratio ratio(fine_grid, coarse_grid);
  const auto bend_along_y = [&](const Field<double>& from, Field<double>& to) {
    for (int I = 0; I < coarse_grid.nx(); ++I) {
      for (int J = inner.begin; J < inner.end; ++J) {
        to.row(I)[J] = from.row(I)[J - 1] - 2.0 * from.row(I)[J] + from.row(I)[J + 1];
      }
    }
    halo.exchange(to);
  };
  for (int I = 1; I < coarse_grid.nx() - 1; ++I) {
    for (int J = 0; J < coarse_grid.y_count(); ++J) {
      bend_x.row(I)[J] = values.row(I - 1)[J] - 2.0 * values.row(I)[J] + values.row(I + 1)[J];
    }
  }
  halo.exchange(bend_x);
  bend_along_y(values, bend_y);
  bend_along_y(bend_x, bend_xy);
  for (int i = 0; i < fine_grid.nx(); ++i) {
    const int below = i / ratio.x, above = (i + ratio.x - 1) / ratio.x;
    for (int j = 0; j < fine_grid.y_count(); ++j) {
      const int row = fine_grid.y_begin() + j;
      const int J = row / ratio.y - coarse_grid.y_begin();
      const int J_next = (row + ratio.y - 1) / ratio.y - coarse_grid.y_begin();
      const auto mean = [&](const Field<double>& field) {
        return 0.25 * (field.row(below)[J] + field.row(below)[J_next] + field.row(above)[J] + field.row(above)[J_next]);
      };
      const double along_x = below == above ? 0.0 : 0.125, along_y = J == J_next ? 0.0 : 0.125;
      fine.row(i)[j] =
          mean(values) - along_x * mean(bend_x) - along_y * mean(bend_y) + along_x * along_y * mean(bend_xy);
    }
  }
}

void inject(const Grid& fine_grid, const Grid& coarse_grid, const Field<double>& fine, Field<double>& coarse) {
  const Ratio ratio(fine_grid, coarse_grid);
  for (int I = 0; I < coarse_grid.nx(); ++I) {
    for (int J = 0; J < coarse_grid.y_count(); ++J) {
      coarse.row(I)[J] = fine.row(ratio.x * I)[same_row(fine_grid, coarse_grid, ratio.y, J)];
    }
  }
}

FilmState injected_state(const Grid& fine_grid, const Grid& coarse_grid, const Halo& coarse_halo,
                         const FilmState& fine) {
  FilmState coarse(coarse_grid);
  coarse.of_rates = fine.of_rates;
  for (const auto field : state_fields) inject(fine_grid, coarse_grid, fine.*field, coarse.*field);
  if (fine.across) inject(fine_grid, coarse_grid, *fine.across, coarse.across.emplace(coarse_grid));
  if (fine.rough) {
    RoughGap& gap = coarse.rough.emplace(coarse_grid);
    for (const auto field : rough_gap_fields) inject(fine_grid, coarse_grid, (*fine.rough).*field, gap.*field);
  }
  exchange_ghosts(coarse_halo, coarse);
  return coarse;
}

template void restrict_residual(const Grid&, const Grid&, const Field<float>&, const Field<float>&, Field<float>&);
template void restrict_residual(const Grid&, const Grid&, const Field<double>&, const Field<double>&, Field<double>&);
template void add_interpolated(const Grid&, const Grid&, const Field<float>&, const Field<float>&, Field<float>&);
template void add_interpolated(const Grid&, const Grid&, const Field<double>&, const Field<double>&, Field<double>&);

}  // namespace gearfilm
