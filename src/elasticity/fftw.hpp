// FFTW's double and single precision interfaces under one name, with owning plans and buffers.
#pragma once

#include <fftw3.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace gearfilm::fftw {

template <class Real>
struct Interface;

template <>
struct Interface<double> {
  using Plan = fftw_plan;
  using Complex = fftw_complex;
  static constexpr auto many_r2c = fftw_plan_many_dft_r2c;
  static constexpr auto many_c2r = fftw_plan_many_dft_c2r;
  static constexpr auto many_c2c = fftw_plan_many_dft;
  static constexpr auto guru_c2c = fftw_plan_guru_dft;
  static constexpr auto execute = fftw_execute;
  static constexpr auto destroy = fftw_destroy_plan;
};

template <>
struct Interface<float> {
  using Plan = fftwf_plan;
  using Complex = fftwf_complex;
  static constexpr auto many_c2c = fftwf_plan_many_dft;
  static constexpr auto guru_c2c = fftwf_plan_guru_dft;
  static constexpr auto execute = fftwf_execute;
  static constexpr auto destroy = fftwf_destroy_plan;
};

/// Not measured: a measurement may choose differently in the next run, whose results would differ in the last digits.
constexpr unsigned effort = FFTW_ESTIMATE;

/// A planned transform between fixed buffers; an empty one does nothing.
template <class Real>
class Plan {
public:
  using Raw = typename Interface<Real>::Plan;
  Plan() = default;
  explicit Plan(Raw raw) : raw_(raw) {
    if (!raw) throw std::bad_alloc();
  }
  void execute() const {
    if (raw_) Interface<Real>::execute(raw_.get());
  }

private:
  struct Destroy {
    void operator()(Raw raw) const { Interface<Real>::destroy(raw); }
  };
  std::unique_ptr<std::remove_pointer_t<Raw>, Destroy> raw_;
};

/// Zeroed, aligned memory as FFTW wants it.
template <class Value>
class Buffer {
public:
  explicit Buffer(std::size_t size)
      : values_(static_cast<Value*>(fftw_malloc(std::max<std::size_t>(size, 1) * sizeof(Value)))) {
    if (!values_) throw std::bad_alloc();
    std::fill_n(values_.get(), std::max<std::size_t>(size, 1), Value{});
  }
  Value* data() { return values_.get(); }
  const Value* data() const { return values_.get(); }

private:
  struct Free {
    void operator()(Value* memory) const { fftw_free(memory); }
  };
  std::unique_ptr<Value, Free> values_;
};

/// The smallest even length >= n whose prime factors are 2, 3, 5, 7.
inline int fast_length(int n) {
  for (n += n % 2;; n += 2) {
    int rest = n;
    for (int factor : {2, 3, 5, 7}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return n;
  }
}

}  // namespace gearfilm::fftw
