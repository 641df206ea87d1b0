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
// transformed in y, multiplied by the kernel's transform, and back: a few wave numbers at a time, so that what is
// padded in y is neither communicated nor stored as a whole. Two rows are transformed in x as one complex row, which
// FFTW does with vector instructions and two real ones it does not:
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

  double elastic_coefficient() const { return C_h_; }
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
  void plan_transforms();
  void transform_kernel();
  /// The transforms in x of what the x-lines hold, to where load() finds them.
  void to_waves() const;
  /// Back from where store() puts them.
  void from_waves() const;
  /// The transform in x of all rows at an own wave number, from or into its y-line.
  void load(int k, Complex* line) const;
  void store(int k, const Complex* line) const;
  /// A wave number's pieces in exchanged_: move(first row, piece, rows).
  template <class Move>
  void for_each_piece(int k, Move move) const;
  /// The transform in x of the own rows at one wave number, out of those of their pairs or into them.
  void separate_rows(int k, Complex* rows) const;
  void combine_rows(int k, const Complex* rows) const;
  /// Calls work(first wave number, count) for all own ones.
  template <class Work>
  void for_each_bundle(Work work) const;
  /// The transform in y of one wave number times that of the kernel.
  void multiply_by_kernel(int k, Complex* line) const;
  /// The transforms in x of K at the distances first, first + 1, ... in y.
  void kernel_to_waves(int first);
  /// Pairs of rows as reals, at a place or a wave number.
  Real* x_row(int i) const { return reinterpret_cast<Real*>(x_lines_.data() + static_cast<std::size_t>(i) * pairs_); }
  Complex* y_line(int n) const { return y_lines_.data() + static_cast<std::size_t>(n) * length_y_; }
  Complex* y_wave(int n) const { return y_waves_.data() + static_cast<std::size_t>(n) * length_y_; }
  Complex* own_spectrum(int k) const { return x_spectrum_.data() + static_cast<std::size_t>(k) * own_rows_; }
  /// Where the kernel's transforms of a wave number begin.
  std::size_t kernel_at(int k) const { return static_cast<std::size_t>(k) * (length_y_ / 2 + 1); }
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
  // Work space of apply(); [x or wave number][y], y contiguous.
  mutable fftw::Buffer<Complex> x_lines_;     ///< [length_x][pairs], transformed in place; padded from nx - 1 on
  mutable fftw::Buffer<Complex> x_spectrum_;  ///< [all wave numbers][own rows]; empty on one process
  mutable fftw::Buffer<Complex> exchanged_;   ///< pieces as they travel; empty on one process
  mutable fftw::Buffer<Complex> y_lines_;     ///< a bundle: [wave numbers][length_y], zero from rows on
  mutable fftw::Buffer<Complex> y_waves_;     ///< its transform, and the result's back in place
  // [own wave numbers][length_y/2 + 1], with the factor of the inverse transform.
  std::vector<Real> kernel_;            ///< W, real and even since K is
  std::vector<Complex> mirror_kernel_;  ///< V
  fftw::Plan<Real> x_forward_, x_backward_, y_forward_, y_backward_;
};

extern template class Deformation<float>;
extern template class Deformation<double>;

}  // namespace gearfilm
