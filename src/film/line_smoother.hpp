// Hybrid distributive line relaxation for the linearised film.
//
// All x-lines are relaxed at once (Jacobi), each by a direct solve of a band of half-width 3. Where conduction is
// weak against deformation, xi_R/h_x^2 < 1.5, the unknown of a node is a distributive change: +1 at the node, -w_x at
// its x-neighbours, -w_y at its y-neighbours, w = (1/h^2)/(2 (1/h_x^2 + 1/h_y^2)). Its deformation is the discrete
// Laplacian of the kernel and dies out within three cells, so the band is accurate. Elsewhere the change is plain. The
// limit: by the wedge alone, a plain change of long wave length moves the row by U 2 pi C_h ~ 1 per unit, against
// 2 xi_R/h_x^2 in the band; a limit of 0.3 lets such waves grow (films of low pressure on fine grids then fail), and
// beyond 3 well conducting nodes are relaxed badly.
// A wave exp(ikX) of a plain change moves its row by xi_R k^2 + i U rho 2 pi C_h, the second part whatever its length;
// the band, which holds near deformation only, has nothing of it for long waves, and relaxation would multiply them.
// Half of its size stands on the diagonal of plain changes. Damped by 0.75, both kinds alike: where they meet,
// different dampings (0.6 and 0.8) leave errors of long wave length that grow with the grid. Lines being updated
// together, the number of processes is irrelevant.
//
// A film that oscillates as exp(s T) has complex rows. Waves that oil carries along, exp(ikX) with i k U = -s, move
// their rows by conduction alone, since wedge and squeeze, (U d/dX + s) K, cancel. So must they in the band, or it has
// no such waves or others in their place, and relaxation fails on them all: deformation is cut off before the wedge's
// differences are taken, one cell away, and what is left of it fits into the band whole. A plain change of long wave
// length moves its row by (U + |s|/k) 2 pi C_h, and the limit grows likewise, with k = 2. Source of the idea: Venner
// and Lubrecht, Multilevel Methods in Lubrication (2000), ch. 6.
#pragma once

#include <array>

#include "film/smoother.hpp"

namespace gearfilm {

template <class Real>
class LineSmoother final : public Smoother<Real> {
public:
  using Part = PartOf<Real>;

  LineSmoother(const Grid& grid, const Halo& halo, const Deformation<Part>& deformation);

  void factor(const FilmStencil<Real>& linear, const FilmState& state, ShiftOf<Real> shift,
              SmootherFactors factors) override;
  void relax(Field<Real>& residual, Field<Real>& change) override;

private:
  static constexpr int half_width = 3;
  static constexpr int band_width = 2 * half_width + 1;
  static constexpr int reach = half_width + 2;  ///< furthest node whose deformation the band needs
  /// Furthest node whose deformation it has.
  static constexpr int kept = std::is_floating_point_v<Real> ? reach : 1;

  /// Deformation at a node (i, j) cells away from a unit change.
  struct Influence {
    std::array<Part, reach + 1> same_line{};  ///< i = 0..reach, j = 0
    std::array<Part, reach + 1> next_line{};  ///< j = 1
  };

  Real* band(int i, int offset) {
    return band_.data() + (static_cast<std::size_t>(i) * band_width + offset + half_width) * rows_;
  }
  void choose_unknowns(const FilmState& state, double oscillation);
  template <int offset>
  void assemble_diagonal(const FilmStencil<Real>& linear, int i);
  template <int... index>
  void assemble_line(const FilmStencil<Real>& linear, int i, std::integer_sequence<int, index...>);
  void add_distant_deformation(const FilmState& state, int i);
  void factor_bands();
  void solve_bands(Field<Real>& values);

  const Halo& halo_;
  int nx_;
  int rows_;
  double inverse_h_x2_;
  double long_wave_deformation_;  ///< 2 pi C_h
  Part weight_x_;                 ///< w_x
  Part weight_y_;                 ///< w_y
  Influence plain_;
  Influence correction_;      ///< distributive minus plain
  std::vector<Real> band_;    ///< [x][diagonal][y], factored in place
  Field<Part> distributive_;  ///< 1 where the unknown is a distributive change
  using Smoother<Real>::coupled_;
  Field<Real> spread_;  ///< distributive changes, with ghosts
};

extern template class LineSmoother<float>;
extern template class LineSmoother<double>;
extern template class LineSmoother<std::complex<double>>;

}  // namespace gearfilm
