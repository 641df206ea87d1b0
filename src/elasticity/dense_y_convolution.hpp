// Few rows, or rows at unequal distances: the convolution in y as sums over rows, wave number by wave number in x.
//
// K is even in x, and so its transforms in x are real: with q the stored rows (deformation.hpp)
//   D(j) = sum_l G(j, l) q(l)
//   equal rows:   G(j, l) = K(j-l) + K(j+l)     the second term where rows are mirrored in the first one
//   unequal rows: G(j, l) = K_jl, the transform of the deformation at row j by the cell of row l, and by its image
// is a product of a real matrix and a complex vector, without padding. Transforms in y cost less only where there are
// many equal rows.
//
// Matrices are larger than the nearest cache: those of k and of length - k are the same, and two fields at once
// (field_pair_spectra.hpp) meet four right sides with one reading of it.
//
// Each process sums for its own rows and needs those of all others. They travel once, in pieces of a few wave numbers,
// while the process sums over its own: transforms in y need two transpositions, and all that wait for both.
#pragma once

#include <array>

#include "elasticity/y_convolution.hpp"

namespace gearfilm {

template <class Real>
class DenseYConvolution : public YConvolution<Real> {
public:
  /// Whether sums are the faster way for so many rows, and their matrix small enough for a cache.
  static bool serve(int waves, int rows);
  /// Messages in which the spectra of rows travel to another process.
  static int pieces(int waves, int rows);

  /// Convolution between equal rows. The kernel is transformed in the spectra, whose content is lost.
  DenseYConvolution(const Grid& grid, const Influence& kernel, XSpectra<Real>& spectra);
  /// Convolution between rows at any distances: transforms the influence of every row on every other one.
  DenseYConvolution(const Grid& grid, const RowInfluence& kernel, XSpectra<Real>& spectra);

  void apply(XSpectra<Real>& spectra) override;
  bool serves_pairs() const override { return processes() == 1; }
  void apply(FieldPairSpectra<Real>& spectra) override;

private:
  using Complex = std::complex<Real>;
  DenseYConvolution(const Grid& grid, const XSpectra<Real>& spectra);
  void fill_matrix(const RowAxis& rows, const Influence& kernel, XSpectra<Real>& spectra);
  void fill_matrix(const RowInfluence& kernel, XSpectra<Real>& spectra);
  /// What a source row adds to an own row at a wave number.
  Real& entry(int k, int source, int own) {
    return matrix_
        .data()[((static_cast<std::size_t>(k) * blocks_ + own / width_) * sources_ + source) * width_ + own % width_];
  }
  /// Sums over the rows of one process: added to those at a wave number.
  void add(int k, int process, const Complex* rows, Real* sums) const;
  /// Columns of all rows become their products with the matrix of a wave number, on one process.
  template <std::size_t several>
  void multiply(int k, const std::array<Complex*, several>& rows);
  /// The own rows of one of so many columns, whose sums begin here.
  void store(const Real* sums, int columns, Complex* rows) const;
  void apply_alone(XSpectra<Real>& spectra);
  int rows_of(int process) const { return y_ranges_[process + 1] - y_ranges_[process]; }
  int processes() const { return static_cast<int>(y_ranges_.size()) - 1; }
  int first_wave(int piece) const { return static_cast<int>(static_cast<long>(waves_) * piece / pieces_); }
  /// What a process has at a wave number; of the own rows what is sent.
  Complex* spectrum(int process, int k) {
    return spectra_.data() + static_cast<std::size_t>(waves_) * y_ranges_[process] +
           static_cast<std::size_t>(k) * rows_of(process);
  }
  int sums_size() const { return blocks_ * 2 * width_; }  ///< at a wave number
  const Real* block_at(int k, int block) const {
    return matrix_.data() + (static_cast<std::size_t>(k) * blocks_ + block) * sources_ * width_;
  }
  Real* sums_at(int k) { return sums_.data() + static_cast<std::size_t>(k) * sums_size(); }

  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0;
  int waves_ = 0;
  int sources_ = 0;  ///< rows that may deform: all but the last, where P = 0
  int width_ = 0;    ///< own rows that are summed side by side, and some more to fill vectors
  int blocks_ = 0;   ///< of so many rows
  std::vector<int> y_ranges_;
  int pieces_ = 0;
  fftw::Buffer<Real> matrix_;      ///< [wave number][block][source][own row of it], with the inverse's factor
  fftw::Buffer<Complex> spectra_;  ///< [process][wave number][row]
  fftw::Buffer<Real> sums_;        ///< [wave number][block][real, imaginary][own row of it]
  std::vector<Complex> result_;    ///< of the own rows at a wave number
  std::vector<MPI_Request> received_, sent_;
};

extern template class DenseYConvolution<float>;
extern template class DenseYConvolution<double>;

}  // namespace gearfilm
