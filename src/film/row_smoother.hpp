// Relaxation of the linearised film row by row, each by a direct solve of its whole matrix.
//
// The matrix of a row has all its coupled nodes, full ones and those whose asperities carry: what their pressures
// change in the row by conduction and wedge, and by the deformation of the row itself and of the rows beside it,
// however far along X; but pressure in the inlet changes only what is near. All rows are relaxed at once (block
// Jacobi), and then corrected for how they deform one another (deformation_between_rows.hpp) and for the oil that they
// conduct into one another (flow_between_rows.hpp), which also takes up nodes that are coupled now, but were not when
// factors were made. Krylov's method takes 3 to 7 of these where rows are graded towards the ends of a face.
//
// Factors cost as much as ten or more relaxations. In time steps of equal length they serve later linearisations too,
// until one takes more relaxations than all since the factors were made have cost on average, the factors included:
// from there on every further use would make the average grow.
#pragma once

#include <array>
#include <vector>

#include "film/deformation_between_rows.hpp"
#include "film/flow_between_rows.hpp"
#include "film/row_factors.hpp"
#include "film/smoother.hpp"

namespace gearfilm {

template <class Real>
class RowSmoother final : public Smoother<Real> {
public:
  using Part = PartOf<Real>;

  /// Grid and halo must outlive the smoother.
  RowSmoother(const Grid& grid, const Halo& halo, const Deformation<Part>& deformation);

  void factor(const FilmStencil<Real>& linear, const FilmState& state, ShiftOf<Real> shift,
              SmootherFactors factors) override;
  void relax(Field<Real>& residual, Field<Real>& change) override;
  bool relax_displacement(const Field<Real>& column, Field<Real>& change) override;
  /// What the changes of each row are where those of all others are zero.
  void solve_rows(const Field<Real>& residual, Field<Real>& change);

private:
  enum At { row_before, own_row, row_after, places };

  /// Deformation at one of three rows by unit pressure on an own row, at distances of -nx..nx lines; [0] is in the
  /// middle.
  const Part* influence(At at, int j) const {
    return influence_[at].data() + static_cast<std::size_t>(j) * (2 * nx_ + 1) + nx_;
  }
  /// change += relaxed_, corrected, for this residual.
  void add_corrected(const Field<Real>& residual, Field<Real>& change);
  /// Fills the matrix of the coupled nodes of row j, column by column as its factors take it.
  void assemble(const FilmStencil<Real>& linear, int j, std::vector<Real>& matrix);
  /// Factors the matrices of all rows at their present coupled nodes.
  void make_factors(const FilmStencil<Real>& linear);
  /// Whether the present factors serve a linearisation about this state as well. Collective.
  bool serve(ShiftOf<Real> shift) const;

  struct Row {
    std::vector<int> coupled;  ///< lines of the nodes that were coupled when its factors were made
    RowFactors<Real> factors;
  };
  /// The changes of a row in the place of its residual, whose other nodes have zero.
  void solve_row(const Row& row, Real* line);
  /// What the present factors have been used for.
  struct Use {
    ShiftOf<Real> shift{};
    double cost = 0.0;  ///< of the factors, in relaxations
    int linearisations = 0;
    int relaxations = 0;  ///< of all of them
    int last = 0;         ///< of the last one
  };

  MPI_Comm comm_;
  int nx_;
  bool single_;  ///< no rows beside it
  std::array<std::vector<Part>, places> influence_;
  std::vector<Row> rows_;
  double long_wave_deformation_;  ///< 2 pi C_h
  Field<Part> factored_;          ///< coupled() when factors were made
  Field<Part> solved_;            ///< 1 where it is so now too: factors are used
  Field<Real> inverse_scale_;     ///< of nodes that are not coupled, in a single row of all others, else 0
  Use use_;
  DeformationBetweenRows<Real> deformation_between_;
  FlowBetweenRows<Real> flow_between_;
  Field<Real> relaxed_;
  std::size_t line_;          ///< of the following, more than nx
  std::vector<Real> lines_;   ///< [row][x]
  std::vector<Real> values_;  ///< of the coupled nodes of a row
};

extern template class RowSmoother<float>;
extern template class RowSmoother<double>;
extern template class RowSmoother<std::complex<double>>;

}  // namespace gearfilm
