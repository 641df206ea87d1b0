// Transforms in x of the own rows of a field, for a convolution (deformation.hpp).
//
// Zero-padded. Two rows are transformed as one complex row, which FFTW does with vector instructions and two real ones
// it does not:
//   Z = A + i B ,  A(k) = (Z(k) + conj Z(-k))/2 ,  B(k) = (Z(k) - conj Z(-k))/(2 i)
#pragma once

#include "elasticity/line_transforms.hpp"
#include "grid/field.hpp"

namespace gearfilm {

template <class Real>
class XSpectra {
public:
  using Complex = std::complex<Real>;

  explicit XSpectra(const Grid& grid);

  int own_rows() const { return own_rows_; }
  /// Length of the padded lines; a transform and its inverse together multiply by it.
  int length() const { return length_; }
  /// Wave numbers 0, 1, ... of real rows.
  int waves() const { return length_ / 2 + 1; }

  /// A row of symmetry counts half, for it coincides with its mirror image. What the field has at the boundary, where
  /// it is to be zero, is not read.
  void transform(const Field<Real>& field);
  /// Transforms rows that are even in x, given by value(i, j) at a distance of i lines in the own row j.
  template <class Value>
  void transform_even(Value value) {
    clear();
    for (int i = 0; i < nx_ - 1; ++i) {
      for (int j = 0; j < own_rows_; ++j) {
        line(i)[j] = static_cast<Real>(value(i, j));
        if (i > 0) line(length_ - i)[j] = line(i)[j];
      }
    }
    transforms_.forward();
  }
  /// The own rows at one wave number, and back.
  void separate(int k, Complex* rows) const;
  void combine(int k, const Complex* rows);
  /// The rows of which the transforms are there, on all own nodes of a field; its ghosts stay.
  void transform_back(Field<Real>& field);

private:
  void clear() { std::fill_n(lines_.data(), static_cast<std::size_t>(length_) * pairs_, Complex(0)); }
  /// Pairs of rows as reals: at a place i along X, and at a wave number k.
  Real* line(int i) { return reinterpret_cast<Real*>(lines_.data() + static_cast<std::size_t>(i) * pairs_); }
  const Real* line(int i) const {
    return reinterpret_cast<const Real*>(lines_.data() + static_cast<std::size_t>(i) * pairs_);
  }
  Real* wave(int k) { return line(transforms_.place(k)); }
  const Real* wave(int k) const { return line(transforms_.place(k)); }

  int nx_;
  int own_rows_;
  RowRange inner_;  ///< own rows that are not at the boundary
  int mirror_row_;  ///< own row of symmetry, or -1
  int pairs_;       ///< of own rows; the last row may be alone, the last pair empty
  int length_;
  fftw::Buffer<Complex> lines_;  ///< [length][pairs], transformed in place; padded from nx - 1 on
  LineTransforms<Real> transforms_;
};

extern template class XSpectra<float>;
extern template class XSpectra<double>;

}  // namespace gearfilm
