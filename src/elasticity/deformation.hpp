// Elastic deformation of the half-space under the film pressure,
//
//   (K P)(X, Y) = C_h Int Int P(X', Y') / sqrt((X-X')^2 + (Y-Y')^2) dX' dY',
//
// with P constant on the cell around each node (Love 1929, doi 10.1098/rsta.1929.0009): exact for that pressure,
// and in x, between equal rows in y too, a discrete convolution, done as a zero-padded Fourier transform in O(N log N).
// P = 0 on the boundary: what a field has there is not read, so that 2^n + 1 nodes need transforms of length 2^(n+1).
//
// Where rows are mirrored in Y = 0 (row_axis.hpp), with q the values of P at Y >= 0, those at Y = 0 halved, row j of
// the deformation is
//   sum_l ( K(j-l) + K(j+l) ) q(l) .
//
// Rows at unequal distances have cells that reach half-way to their neighbours, and so a kernel for each pair of rows.
// What the ends of a face change (end_faces.hpp) is added to these. A single row is that of a line contact.
//
// Rows are transformed in x (x_spectra.hpp; local, the grid is cut in y). In y few or unequal rows are summed over
// (dense_y_convolution.hpp), many equal ones are transformed too (fft_y_convolution.hpp).
#pragma once

#include <span>

#include "elasticity/end_faces.hpp"
#include "elasticity/love.hpp"
#include "elasticity/y_convolution.hpp"

namespace gearfilm {

/// The operator K on one grid. All processes of the grid call it together.
template <class Real>
class Deformation {
public:
  /// ends: null where both are far away.
  Deformation(const Grid& grid, double C_h, std::shared_ptr<const EndFaceCompliance> ends = {});

  /// deformation = K pressure on the own nodes; ghosts are neither read nor written.
  void apply(const Field<Real>& pressure, Field<Real>& deformation) const;
  /// Each deformation = K times the pressure of the same place, two at a time where that is faster; as above.
  void apply(std::span<const Field<Real>* const> pressures, std::span<Field<Real>* const> deformations) const;

  double elastic_coefficient() const { return C_h_; }
  /// K between nodes that are i lines and j equal rows apart.
  double coefficient(int i, int j) const {
    const double h_y = rows_.equal_step();
    return C_h_ * love_kernel(i * h_x_, j * h_y, h_x_, h_y);
  }
  /// Deformation at a row, i lines away from unit pressure on the cell of a source row and on its mirror image, with
  /// what ends of the face add.
  double coefficient(int i, int row, int source) const;

private:
  double C_h_;
  double h_x_;
  RowAxis rows_;
  std::shared_ptr<const EndFaceCompliance> ends_;
  // Work space of apply() within.
  mutable XSpectra<Real> spectra_;
  std::unique_ptr<YConvolution<Real>> across_;
  std::unique_ptr<FieldPairSpectra<Real>> pair_spectra_;  ///< null where fields are taken one at a time
};

extern template class Deformation<float>;
extern template class Deformation<double>;

}  // namespace gearfilm
