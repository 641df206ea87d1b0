// Transforms in x of two fields at once, for a convolution whose transforms are real (deformation.hpp).
//
// The rows of one field are the real, those of the other the imaginary parts of complex rows. A real kernel mixes them
// nowhere: what rows of Z = A + i B become is the deformation by A plus i times that by B, so that nothing is to be
// taken apart on the way, as it is between rows that are paired with each other (x_spectra.hpp).
#pragma once

#include "elasticity/line_transforms.hpp"
#include "grid/field.hpp"

namespace gearfilm {

template <class Real>
class FieldPairSpectra {
public:
  using Complex = std::complex<Real>;

  /// Lines padded to this length, as those of an XSpectra whose kernel they meet.
  FieldPairSpectra(const Grid& grid, int length);

  int length() const { return length_; }
  /// As XSpectra reads and writes fields.
  void transform(const Field<Real>& real, const Field<Real>& imaginary);
  void transform_back(Field<Real>& real, Field<Real>& imaginary);
  /// The own rows at a wave number 0, 1, ..., length - 1; those of k and length - k meet the same kernel.
  Complex* rows(int k) { return line(transforms_.place(k)); }

private:
  Complex* line(int i) { return lines_.data() + static_cast<std::size_t>(i) * stride_; }

  int nx_;
  int own_rows_;
  int stride_;      ///< from line to line
  RowRange inner_;  ///< own rows that are not at the boundary
  int mirror_row_;  ///< own row of symmetry, or -1
  int length_;
  fftw::Buffer<Complex> lines_;  ///< [length][own row and what is left of the stride], transformed in place
  LineTransforms<Real> transforms_;
};

extern template class FieldPairSpectra<float>;
extern template class FieldPairSpectra<double>;

}  // namespace gearfilm
