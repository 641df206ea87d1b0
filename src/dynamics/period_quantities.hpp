// The quantities of one mesh period, as the tables of quantities name them.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/step_quantities.hpp"

namespace gearfilm {

/// One quantity of a mesh period, and the quantity it is reduced from.
struct PeriodQuantity : Reduced {
  std::size_t source = 0;   ///< place in step_quantities or contact_quantities
  bool of_contact = false;  ///< which of them
  RequiredModel needs = RequiredModel::nothing;
};

namespace detail {

template <class Visit>
constexpr void for_each_reduced(Visit visit) {
  const auto visit_table = [&](const auto& table, bool of_contact) {
    for (std::size_t n = 0; n < table.size(); ++n) {
      for (const Reduced& reduced : table[n].reduced) {
        if (!reduced.name.empty()) visit(PeriodQuantity{reduced, n, of_contact, table[n].needs});
      }
    }
  };
  visit_table(contact_quantities, true);
  visit_table(step_quantities, false);
}

constexpr std::size_t reduced_count() {
  std::size_t count = 0;
  for_each_reduced([&](const PeriodQuantity&) { ++count; });
  return count;
}

constexpr auto all_reduced() {
  std::array<PeriodQuantity, reduced_count()> all{};
  std::size_t next = 0;
  for_each_reduced([&](const PeriodQuantity& quantity) { all[next++] = quantity; });
  return all;
}

}  // namespace detail

inline constexpr auto period_quantities = detail::all_reduced();

/// A quantity by its name: one that does not exist ends the compilation.
struct PeriodQuantityName {
  consteval PeriodQuantityName(const char* name) : place(place_in(period_quantities, name)) {}
  std::size_t place;
};

/// Values of one mesh period, dimensionless, in the order of period_quantities. Those that nothing has given are
/// absent: the films of the dry model, an entry in a period without.
struct PeriodQuantities {
  std::array<std::optional<double>, period_quantities.size()> values{};

  const std::optional<double>& operator[](PeriodQuantityName name) const { return values[name.place]; }
};

}  // namespace gearfilm
