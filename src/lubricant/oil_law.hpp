// What the laws of an oil have in common: their constants as a case file gives them, and lists of laws.
//
// A list of laws is a std::variant (lubricant.hpp). Which law an oil has is asked once, outside of loops, by
// std::visit: inside, the law's Evaluator is a type of its own, so that compilers use vector instructions.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace gearfilm {

/// A constant of a law, of which the input makes a parameter in the section `lubricant`.
struct OilConstant {
  std::string_view name;  ///< key in that section
  std::string_view symbol;
  std::string_view unit;  ///< "-" for pure numbers
  double lower, upper;    ///< what is allowed; the upper end always is
  bool lower_open;        ///< the lower end itself is not allowed
  std::string_view meaning;
  /// Where it is not given: nothing, it is needed; its value; or the key of the parameter whose value it has, with its
  /// section.
  std::variant<std::monostate, double, std::string_view> standard = {};
  std::string_view former = {};  ///< its key in earlier releases; empty where it is the same
};

/// A value and its derivative with respect to pressure [1/Pa].
struct PressureFunction {
  double value;
  double derivative;
};

/// A value and its derivative with respect to temperature [1/K].
struct TemperatureFunction {
  double value;
  double derivative;
};

/// A function of pressure and temperature with its derivatives [1/Pa], [1/K] and the mixed one [1/(Pa K)].
struct StateFunction {
  double value, by_pressure, by_temperature, by_both;
};

/// The constant as one that had another key in earlier releases.
inline OilConstant formerly(std::string_view key, OilConstant constant) {
  constant.former = key;
  return constant;
}

/// The number as messages show it.
std::string shown(double value);

/// Calls body, a function template of a law, for each law of a list in turn.
template <class Laws, class Body>
void each_law(Body body) {
  [&]<std::size_t... n>(std::index_sequence<n...>) {
    (body.template operator()<std::variant_alternative_t<n, Laws>>(), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Laws>>());
}

namespace detail {
template <class Laws>
struct Evaluators;
template <class... Law>
struct Evaluators<std::variant<Law...>> {
  using type = std::variant<typename Law::Evaluator...>;
};
}  // namespace detail

/// The list of what evaluates the laws of a list.
template <class Laws>
using EvaluatorOf = typename detail::Evaluators<Laws>::type;

}  // namespace gearfilm
