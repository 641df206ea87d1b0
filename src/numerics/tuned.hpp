// Constants of algorithms that were chosen by measurement.
//
// Each has a name, under which -NAME in PETSc's options gives it another value, and a meaning (docs/constants.md).
// Results must not hang on them by more than their error bars: scripts/studies/scan_constants tries half and twice
// of each.
#pragma once

#include <type_traits>

namespace gearfilm {

class TunedConstant {
public:
  TunedConstant(const TunedConstant&) = delete;
  TunedConstant& operator=(const TunedConstant&) = delete;

  const char* name() const { return name_; }
  const char* meaning() const { return meaning_; }
  bool whole() const { return whole_; }
  double value() const { return value_; }
  double by_default() const { return default_; }

  /// All that there are in the program, one behind the other, in no order.
  static const TunedConstant* first() { return last_made_; }
  const TunedConstant* next() const { return next_; }

  /// Takes all from PETSc's options. Throws InputError for what is no positive number, or no whole one where one is
  /// needed.
  static void read_all();

protected:
  TunedConstant(const char* name, double value, bool whole, const char* meaning) noexcept;
  ~TunedConstant() = default;

private:
  static TunedConstant* last_made_;

  const char* name_;
  const char* meaning_;
  bool whole_;
  double default_, value_;
  TunedConstant* next_;
};

/// Number: double, or int for counts. All live as long as the program.
template <class Number>
class Tuned final : public TunedConstant {
public:
  Tuned(const char* name, Number value, const char* meaning) noexcept
      : TunedConstant(name, value, std::is_integral_v<Number>, meaning) {}

  operator Number() const { return static_cast<Number>(value()); }
};

}  // namespace gearfilm
