// The figures of one mesh period, as the tables of figures name them.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/step_figures.hpp"

namespace gearfilm {

/// One figure of a mesh period, and the figure it is reduced from.
struct PeriodFigure : Reduced {
  std::size_t source = 0;   ///< place in step_figures or contact_figures
  bool of_contact = false;  ///< which of them
  Needs needs = Needs::nothing;
};

namespace detail {

template <class Visit>
constexpr void for_each_reduced(Visit visit) {
  const auto visit_table = [&](const auto& table, bool of_contact) {
    for (std::size_t n = 0; n < table.size(); ++n) {
      for (const Reduced& reduced : table[n].reduced) {
        if (!reduced.name.empty()) visit(PeriodFigure{reduced, n, of_contact, table[n].needs});
      }
    }
  };
  visit_table(contact_figures, true);
  visit_table(step_figures, false);
}

constexpr std::size_t reduced_count() {
  std::size_t count = 0;
  for_each_reduced([&](const PeriodFigure&) { ++count; });
  return count;
}

constexpr auto all_reduced() {
  std::array<PeriodFigure, reduced_count()> all{};
  std::size_t next = 0;
  for_each_reduced([&](const PeriodFigure& figure) { all[next++] = figure; });
  return all;
}

}  // namespace detail

inline constexpr auto period_figures = detail::all_reduced();

/// A figure by its name: one that does not exist ends the compilation.
struct PeriodFigureName {
  consteval PeriodFigureName(const char* name) : place(place_in(period_figures, name)) {}
  std::size_t place;
};

/// Values of one mesh period, dimensionless, in the order of period_figures. Those that nothing has given are absent:
/// the films of the dry model, an entry in a period without.
struct PeriodFigures {
  std::array<std::optional<double>, period_figures.size()> values{};

  const std::optional<double>& operator[](PeriodFigureName name) const { return values[name.place]; }
};

}  // namespace gearfilm
