// Few rows: the convolution in y as sums over rows, wave number by wave number in x.
//
// K is even, and so its transforms in x are real: with q the stored rows (deformation.hpp)
//   D(j) = sum_l G(j, l) q(l) ,  G(j, l) = K(j-l) + K(j+l)     the second term where rows are mirrored in the first one
// is a product of a real matrix and a complex vector, without padding. Transforms in y cost less only where there are
// many rows.
//
// Each process sums for its own rows and needs those of all others. They travel once, in pieces of a few wave numbers,
// while the process sums over its own: transforms in y need two transpositions, and all that wait for both.
#pragma once

#include "elasticity/y_convolution.hpp"

namespace gearfilm {

template <class Real>
class DenseYConvolution : public YConvolution<Real> {
public:
  /// Whether sums are the faster way for so many rows, and their matrix small enough for a cache.
  static bool serve(int waves, int rows);
  /// Messages in which the spectra of rows travel to another process.
  static int pieces(int waves, int rows);

  /// The spectra are work space here, for the kernel's.
  DenseYConvolution(const Grid& grid, const Influence& kernel, XSpectra<Real>& spectra);

  void apply(XSpectra<Real>& spectra) override;

private:
  using Complex = std::complex<Real>;
  void fill_matrix(const RowAxis& rows, const Influence& kernel, XSpectra<Real>& spectra);
  /// Sums over the rows of one process: added to those at a wave number.
  void add(int k, int process, const Complex* rows, Real* sums) const;
  /// Sums as the complex values of rows.
  void combine(int k, const Real* sums, XSpectra<Real>& spectra);
  void apply_alone(XSpectra<Real>& spectra);
  int rows_of(int process) const { return y_ranges_[process + 1] - y_ranges_[process]; }
  int processes() const { return static_cast<int>(y_ranges_.size()) - 1; }
  int first_wave(int piece) const { return static_cast<int>(static_cast<long>(waves_) * piece / pieces_); }
  /// What a process has at a wave number; of the own rows what is sent.
  Complex* spectrum(int process, int k) {
    return spectra_.data() + static_cast<std::size_t>(waves_) * y_ranges_[process] +
           static_cast<std::size_t>(k) * rows_of(process);
  }
  Real* sums_at(int k) { return sums_.data() + static_cast<std::size_t>(k) * 2 * width_; }

  MPI_Comm comm_;
  int rank_;
  int waves_;
  int sources_;  ///< rows that may deform: all but the last, where P = 0
  int width_;    ///< own rows, and some more to fill vectors
  std::vector<int> y_ranges_;
  int pieces_;
  fftw::Buffer<Real> matrix_;      ///< [wave number][source][own row], with the inverse's factor
  fftw::Buffer<Complex> spectra_;  ///< [process][wave number][row]
  fftw::Buffer<Real> sums_;        ///< [wave number][real, imaginary][own row]
  std::vector<Complex> result_;    ///< of the own rows at a wave number
  std::vector<MPI_Request> received_, sent_;
};

extern template class DenseYConvolution<float>;
extern template class DenseYConvolution<double>;

}  // namespace gearfilm
