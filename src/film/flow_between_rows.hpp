// Flow of oil between rows that were relaxed one by one.
//
// Whoever relaxes whole rows leaves out what their changes of pressure z conduct into the rows beside them. With
// V_s, V_n of the film's stencil (film_stencil.hpp), the correction w of the pressures takes up that flow:
//
//   V w = -(V_s z_south + V_n z_north)         V: all pressure terms of the stencil, without deformation
//
// Nodes that were left out of their rows, z = 0 there, have all of their residual r in the right side instead:
//
//   V w = r - V z
//
// Well conducting oil makes w smooth along X and far-reaching across rows that lie close together; where oil conducts
// badly w is nothing. V is solved approximately, by successive over-relaxation of rows: the even and the odd ones by
// turns, all of them at once (zebra), each by elimination along X. Flow from w across the rows of another process is
// left out.
#pragma once

#include <array>
#include <vector>

#include "film/film_stencil.hpp"
#include "grid/halo.hpp"

namespace gearfilm {

template <class Real>
class FlowBetweenRows {
public:
  /// The halo must outlive the object.
  FlowBetweenRows(const Grid& grid, const Halo& halo);

  /// Factors V along the rows. left_out: 1 at own nodes that are left out of their rows, else 0.
  void factor(const FilmStencil<Real>& linear, const Field<PartOf<Real>>& left_out);
  /// change += w for z = change, whose ghosts it fills.
  void correct(const Field<Real>& residual, Field<Real>& change);

private:
  /// Every second of the own rows: values [x][row]. Beyond the first and the last x, and beside the first and the last
  /// row, all are zero.
  struct Rows {
    Rows(int first, int nx, int y_count);

    int first;  ///< of the own rows
    int count;
    // Factors along X: L has two diagonals, U one beside its own.
    std::vector<Real> lower_2, lower_1, inverse_pivots, upper;
    std::vector<Real> south, north;
    std::vector<Real> right_side, solved, change;
  };

  static constexpr std::size_t lines_before = 2;
  static std::size_t at(const Rows& own, int i) {
    const auto line = static_cast<std::size_t>(i) + lines_before;  // i = -2 is the first
    return line * (own.count + 2) + 1;
  }
  /// A node that was left out of its row, with V along X.
  struct LeftOut {
    int i, j;
    Real west_west, west, east;
  };

  /// Relaxes every second row.
  void relax(Rows& own, const Rows& others);

  const Halo& halo_;
  int nx_;
  std::array<Rows, 2> rows_;  ///< the even and the odd ones
  std::vector<LeftOut> left_out_;
};

extern template class FlowBetweenRows<float>;
extern template class FlowBetweenRows<double>;
extern template class FlowBetweenRows<std::complex<double>>;

}  // namespace gearfilm
