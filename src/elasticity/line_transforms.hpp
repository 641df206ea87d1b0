// Fourier transforms of complex lines that lie side by side, in place: element n of line l at n * count + l.
//
// FFTW transforms short lines that lie so with vector instructions across them. Longer ones it transforms one after
// another, from a copy, unless it may measure which way is faster, which another run would find differently. A length
// N = R S is therefore transformed in two steps, both of short lines; with n = R s + r and k = S p + q
//   Z(k) = sum_r exp(-2 pi i r p / R) exp(-2 pi i r q / N) sum_s exp(-2 pi i s q / S) z(n)
// The wave k then lies at R q + p, and the inverse takes it from there.
#pragma once

#include <vector>

#include "elasticity/fftw.hpp"

namespace gearfilm {

/// How many lines to lay side by side, so that what follows one another in a line is not a power of two apart: a cache
/// has few places for such.
inline int uneven_stride(int lines) { return lines % 16 == 0 ? lines + 1 : lines; }

template <class Real>
class LineTransforms {
public:
  using Complex = std::complex<Real>;

  /// The shortest even length >= n that is transformed fast.
  static int fast_length(int n);

  LineTransforms(Complex* lines, int length, int count);

  /// One after the other multiplies by the length.
  void forward() const;
  void backward() const;
  /// Where the wave k = 0 .. length - 1 is after forward().
  int place(int k) const { return places_[k]; }

private:
  template <class Factor>
  void multiply(Factor factor) const;

  Complex* lines_;
  int count_;
  int R_, S_;  ///< R = 1 where one step transforms all
  std::vector<int> places_;
  std::vector<Complex> factors_;  ///< [q][r], exp(-2 pi i r q / N)
  fftw::Plan<Real> along_s_, along_r_, back_along_r_, back_along_s_;
};

extern template class LineTransforms<float>;
extern template class LineTransforms<double>;

}  // namespace gearfilm
