// Many rows: the convolution in y by transforms of padded lines.
//
// With q the stored rows, both sums of a deformation (deformation.hpp) come from transforms of rows padded to twice
// their number, q^ in y:  W(n) q^(n) + V(n) q^(-n) , W and V being the transforms of K at the distances -M..M and
// 0..2M-1 of M rows. Rows that are not mirrored have no V.
//
// Among processes what the rows have is transposed, and back: then each has all rows at some wave numbers. A few of
// these at a time are transformed, so that what is padded in y is neither communicated nor stored as a whole.
#pragma once

#include "elasticity/y_convolution.hpp"

namespace gearfilm {

template <class Real>
class FftYConvolution : public YConvolution<Real> {
public:
  /// The spectra are work space here, for the kernel's. Collective.
  FftYConvolution(const Grid& grid, const Influence& kernel, XSpectra<Real>& spectra);

  void apply(XSpectra<Real>& spectra) override;

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
  void transform_kernel(const Influence& kernel, XSpectra<Real>& spectra);
  /// What all processes' rows have at the own wave numbers, to where load() finds it; and back from where store() puts
  /// it.
  void gather(const XSpectra<Real>& spectra);
  void scatter(XSpectra<Real>& spectra);
  /// The transform in x of all rows at an own wave number, from or into its line.
  void load(const XSpectra<Real>& spectra, int k, Complex* line) const;
  void store(int k, const Complex* line, XSpectra<Real>& spectra);
  /// A wave number's pieces in exchanged_: move(first row, piece, rows).
  template <class Move>
  void for_each_piece(int k, Move move) const;
  /// Calls work(first wave number, count) for all own ones.
  template <class Work>
  void for_each_bundle(Work work) const;
  /// The transform in y of one wave number times that of the kernel.
  void multiply_by_kernel(int k, Complex* line) const;
  Complex* line(int n) { return lines_.data() + static_cast<std::size_t>(n) * length_; }
  Complex* wave(int n) { return waves_.data() + static_cast<std::size_t>(n) * length_; }
  Complex* own_spectrum(int k) { return spectrum_.data() + static_cast<std::size_t>(k) * own_rows_; }
  /// Where the kernel's transforms of a wave number begin.
  std::size_t kernel_at(int k) const { return static_cast<std::size_t>(k) * (length_ / 2 + 1); }
  int wave_count() const { return wave_ranges_[rank_ + 1] - wave_ranges_[rank_]; }

  MPI_Comm comm_;
  int rank_;
  int rows_;     ///< of all processes
  int sources_;  ///< rows that may deform: all but the last, where P = 0
  bool mirrored_;
  int own_rows_;
  int row_begin_;
  int length_;                    ///< of the padded lines in y
  std::vector<int> wave_ranges_;  ///< first wave number in x of every process, and their number
  std::vector<int> y_ranges_;
  Blocks x_side_;  ///< of spectrum_
  Blocks y_side_;  ///< of exchanged_
  // Work space; [wave number][y], y contiguous.
  fftw::Buffer<Complex> spectrum_;   ///< [all wave numbers][own rows]; empty on one process
  fftw::Buffer<Complex> exchanged_;  ///< pieces as they travel; empty on one process
  fftw::Buffer<Complex> lines_;      ///< a bundle: [wave numbers][length], zero from rows on
  fftw::Buffer<Complex> waves_;      ///< its transform, and the result's back in place
  // [own wave numbers][length/2 + 1], with the factor of the inverse transforms.
  std::vector<Real> kernel_;            ///< W, real and even since K is
  std::vector<Complex> mirror_kernel_;  ///< V; empty where rows are not mirrored
  fftw::Plan<Real> forward_, backward_;
};

extern template class FftYConvolution<float>;
extern template class FftYConvolution<double>;

}  // namespace gearfilm
