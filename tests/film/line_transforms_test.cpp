// Fourier transforms of lines that lie side by side, in one step, in two, and of lengths without short factors.
#include "elasticity/line_transforms.hpp"

#include <gmock/gmock.h>

#include <complex>
#include <numbers>

namespace gearfilm {
namespace {

template <class Real>
class LineTransformsOf : public testing::Test {
protected:
  static constexpr double tolerance = std::is_same_v<Real, double> ? 1e-14 : 5e-6;  // of the largest wave
};
using LinePrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(LineTransformsOf, LinePrecisions);

TYPED_TEST(LineTransformsOf, any_length_are_its_sums_and_go_back) {
  using Complex = std::complex<TypeParam>;
  constexpr int count = 3;
  for (const int length : {2, 12, 34, 96, 128, 210, 768}) {
    fftw::Buffer<Complex> lines(static_cast<std::size_t>(length) * count);
    const auto at = [&](int n, int line) -> Complex& { return lines.data()[n * count + line]; };
    const LineTransforms<TypeParam> transforms(lines.data(), length, count);
    std::vector<Complex> given;
    for (int n = 0; n < length * count; ++n) {
      given.push_back(lines.data()[n] = Complex(std::polar(1.0 + 0.1 * (n % 7), 1.3 * n * n)));
    }
    transforms.forward();
    double error = 0.0, largest = 0.0;
    for (int line = 0; line < count; ++line) {
      for (int k = 0; k < length; ++k) {
        std::complex<double> sum = 0.0;
        for (int n = 0; n < length; ++n) {
          const long turns = static_cast<long>(k) * n % length;  // exactly
          sum += std::complex<double>(given[n * count + line]) *
                 std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(turns) / length);
        }
        error = std::max(error, std::abs(std::complex<double>(at(transforms.place(k), line)) - sum));
        largest = std::max(largest, std::abs(sum));
      }
    }
    EXPECT_LT(error, this->tolerance * largest) << length;
    transforms.backward();
    for (int n = 0; n < length * count; ++n) {
      EXPECT_LT(std::abs(lines.data()[n] / TypeParam(length) - given[n]), this->tolerance * largest) << length;
    }
  }
}

TEST(FastLengths, are_even_and_little_longer) {
  for (int n = 16; n < 5000; ++n) {
    const int length = LineTransforms<double>::fast_length(n);
    EXPECT_EQ(length % 2, 0);
    EXPECT_GE(length, n);
    EXPECT_LE(length, 1.3 * n) << n;
  }
}

}  // namespace
}  // namespace gearfilm
