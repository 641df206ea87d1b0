// Elastic deformation of the half-space under the film pressure,
//
//   (K P)(X, Y) = C_h Int Int P(X', Y') / sqrt((X-X')^2 + (Y-Y')^2) dX' dY',
//
// with P constant on the cell around each node (Love 1929, doi 10.1098/rsta.1929.0009): exact for that pressure,
// and a discrete convolution, done as a zero-padded Fourier transform in O(N log N). P = 0 on the boundary: what a
// field has there is not read, so that 2^n + 1 nodes need transforms of length 2^(n+1).
//
// P is its own mirror image in Y = 0. With q its values at Y >= 0, those at Y = 0 halved, row j of the deformation is
//   sum_l ( K(j-l) + K(j+l) ) q(l) ,
// and both sums come from transforms of half the length, q^ in y:  W(n) q^(n) + V(n) q^(-n) ,
// W and V being the transforms of K at the distances -M..M and 0..2M-1 of M rows.
//
// Distributed: rows are transformed in x (local, the grid is cut in y), transposed among the processes,
// transformed in y, multiplied by the kernel's transform, and back. Padding in y is never communicated. Two rows are
// transformed in x as one complex row, which FFTW does with vector instructions and two real ones it does not:
//   Z = A + i B ,  A(k) = (Z(k) + conj Z(-k))/2 ,  B(k) = (Z(k) - conj Z(-k))/(2 i)
#pragma once

#include "gearfilm/ehl/fftw.hpp"
#include "gearfilm/ehl/field.hpp"

namespace gearfilm {

/// Deformation at distance (x, y) from the centre of a cell h_x by h_y under unit pressure, without C_h.
double love_kernel(double x, double y, double h_x, double h_y);

/// The operator K on one grid. All processes of the grid call it together.
template <class Real>
class Deformation {
public:
  Deformation(const Grid& grid, double C_h);

  /// deformation = K pressure on the own nodes; ghosts are neither read nor written.
  void apply(const Field<Real>& pressure, Field<Real>& deformation) const;

  double C_h() const { return C_h_; }
  /// K between nodes that are i lines and j rows apart.
  double coefficient(int i, int j) const { return C_h_ * love_kernel(i * h_x_, j * h_y_, h_x_, h_y_); }

private:
  using Complex = std::complex<Real>;
  /// What travels to or from every process, in numbers of Real.
  struct Blocks {
    std::vector<int> counts;
    std::vector<int> offsets;
  };

  bool alone() const { return wave_ranges_.size() == 2; }
  void count_blocks();
  template <class Copy>
  void for_each_block_line(Copy copy) const;
  void plan_transforms();
  void transform_kernel();
  /// The transform in x of K at the distances first, first + 1, ... in y, into the y-lines.
  void kernel_to_y_lines(int first);
  void multiply_by_kernel() const;
  /// Pairs of rows as reals, at a place or a wave number.
  Real* x_row(int i) const { return reinterpret_cast<Real*>(x_lines_.data() + static_cast<std::size_t>(i) * pairs_); }
  Real* wave_row(int k) const {
    return reinterpret_cast<Real*>(x_waves_.data() + static_cast<std::size_t>(k) * pairs_);
  }
  Complex* y_line(int k) const { return y_lines_.data() + static_cast<std::size_t>(k) * length_y_; }
  Complex* y_wave(int k) const { return y_waves_.data() + static_cast<std::size_t>(k) * length_y_; }
  /// The spectrum in x of the own rows for one wave number, before and after the transforms in y: on one process it
  /// is their line itself.
  Complex* spectrum_before(int k) const { return alone() ? y_line(k) : own_spectrum(k); }
  Complex* spectrum_after(int k) const { return alone() ? y_wave(k) : own_spectrum(k); }
  Complex* own_spectrum(int k) const { return x_spectrum_.data() + static_cast<std::size_t>(k) * own_rows_; }
  void separate_rows() const;
  void combine_rows() const;
  void to_y_lines() const;
  void to_x_lines() const;
  int wave_count() const { return wave_ranges_[rank_ + 1] - wave_ranges_[rank_]; }

  MPI_Comm comm_;
  int rank_;
  double C_h_;
  double h_x_;
  double h_y_;
  int nx_;
  int rows_;  ///< of all processes
  int own_rows_;
  int row_begin_;
  int pairs_;     ///< of own rows; the last row may be alone, the last pair empty
  int length_x_;  ///< padded lengths of the transforms
  int length_y_;
  std::vector<int> wave_ranges_;  ///< first x wave number of every process, and their number
  std::vector<int> y_ranges_;
  Blocks x_side_;  ///< of x_spectrum_
  Blocks y_side_;  ///< of exchanged_
  // Work space of apply(); [x or wave number][y], y contiguous. What pads a line stays zero.
  mutable fftw::Buffer<Complex> x_lines_;     ///< [length_x][pairs], padded from nx - 1 on
  mutable fftw::Buffer<Complex> x_waves_;     ///< its transform, and the result's back in place
  mutable fftw::Buffer<Complex> x_spectrum_;  ///< [all wave numbers][rows]; empty on one process
  mutable fftw::Buffer<Complex> exchanged_;   ///< blocks as they travel; empty on one process
  mutable fftw::Buffer<Complex> y_lines_;     ///< [own wave numbers and up to three][length_y], padded from rows on
  mutable fftw::Buffer<Complex> y_waves_;     ///< its transform, and the result's back in place
  // [own wave numbers][length_y], with the factor of the inverse transform.
  std::vector<Real> kernel_;            ///< W, real since K is even
  std::vector<Complex> mirror_kernel_;  ///< V
  fftw::Plan<Real> x_forward_, x_backward_, y_forward_, y_backward_;
};

extern template class Deformation<float>;
extern template class Deformation<double>;

}  // namespace gearfilm
