#include "elasticity/line_transforms.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

namespace gearfilm {
namespace {

/// Lengths that FFTW transforms without dividing them; the longest is too long to be one of two.
constexpr int short_lengths[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 20, 32, 64};
constexpr int longest_undivided = 128;

struct Factors {
  int R = 0;
  int S = 0;
};

/// Short lengths R >= S whose product is the length, as near each other as there are; R = 1 where FFTW transforms the
/// length undivided. Nothing for a length that is no product of two short ones.
std::optional<Factors> factors_of(int length) {
  if (length == longest_undivided || std::ranges::binary_search(short_lengths, length)) return Factors{1, length};
  std::optional<Factors> found;
  for (const int S : short_lengths) {
    const int R = length / S;
    if (R < S) break;
    if (R * S == length && std::ranges::binary_search(short_lengths, R)) found = Factors{R, S};
  }
  return found;
}

}  // namespace

template <class Real>
int LineTransforms<Real>::fast_length(int n) {
  const int undivided = fftw::fast_length(n);
  for (int length = n + n % 2; 4 * length <= 5 * undivided; length += 2) {
    if (factors_of(length)) return length;
  }
  return undivided;
}

template <class Real>
LineTransforms<Real>::LineTransforms(Complex* lines, int length, int count) : lines_(lines), count_(count) {
  const Factors factors = factors_of(length).value_or(Factors{1, length});
  R_ = factors.R;
  S_ = factors.S;
  for (int k = 0; k < length; ++k) places_.push_back(R_ * (k % S_) + k / S_);
  for (int q = 0; q < S_; ++q) {
    for (int r = 0; r < R_; ++r) {
      factors_.push_back(Complex(std::polar(1.0, -2.0 * std::numbers::pi * r * q / length)));
    }
  }
  using Fftw = fftw::Interface<Real>;
  const auto plan = [&](const fftw_iodim& along, std::vector<fftw_iodim> others, int sign) {
    auto* raw = reinterpret_cast<typename Fftw::Complex*>(lines);
    return fftw::Plan<Real>(
        Fftw::guru_c2c(1, &along, static_cast<int>(others.size()), others.data(), raw, raw, sign, fftw::effort));
  };
  const int row = R_ * count;  // from one s to the next, or from one q
  along_s_ = plan({S_, row, row}, {{row, 1, 1}}, FFTW_FORWARD);
  back_along_s_ = plan({S_, row, row}, {{row, 1, 1}}, FFTW_BACKWARD);
  if (R_ == 1) return;
  along_r_ = plan({R_, count, count}, {{S_, row, row}, {count, 1, 1}}, FFTW_FORWARD);
  back_along_r_ = plan({R_, count, count}, {{S_, row, row}, {count, 1, 1}}, FFTW_BACKWARD);
}

// Written out in real numbers, which compilers vectorise. Factors of q = 0 and of r = 0 are 1.
template <class Real>
template <class Factor>
void LineTransforms<Real>::multiply(Factor factor) const {
  for (int q = 1; q < S_; ++q) {
    for (int r = 1; r < R_; ++r) {
      const int at = R_ * q + r;
      const Complex by = factor(factors_[at]);
      const Real re = by.real(), im = by.imag();
      Real* line = reinterpret_cast<Real*>(lines_ + static_cast<std::size_t>(at) * count_);
      for (int l = 0; l < count_; ++l) {
        const Real u = line[2 * l], v = line[2 * l + 1];
        line[2 * l] = u * re - v * im;
        line[2 * l + 1] = u * im + v * re;
      }
    }
  }
}

template <class Real>
void LineTransforms<Real>::forward() const {
  along_s_.execute();
  multiply([](const Complex& factor) { return factor; });
  along_r_.execute();
}

template <class Real>
void LineTransforms<Real>::backward() const {
  back_along_r_.execute();
  multiply([](const Complex& factor) { return std::conj(factor); });
  back_along_s_.execute();
}

template class LineTransforms<float>;
template class LineTransforms<double>;

}  // namespace gearfilm
