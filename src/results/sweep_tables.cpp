#include "results/sweep_tables.hpp"

#include <algorithm>
#include <sstream>

#include "dynamics/period_quantities.hpp"
#include "output/results_table.hpp"
#include "output/run_identity.hpp"
#include "results/flank_result.hpp"
#include "results/members.hpp"
#include "results/orbit_summary.hpp"
#include "results/pair_conditions.hpp"
#include "results/poincare_result.hpp"

namespace gearfilm {
namespace {

/// Of a point, under the name of a column; NaN where a point that failed lacks it.
double number(const Summary& point, const std::string& name) {
  if (name == "up") return point["direction"] == "up" ? 1.0 : 0.0;
  if (name == "found") return point.contains("error") ? 0.0 : 1.0;
  return in_row(point.value(name, Summary()));
}

void append_numbers(const Summary& point, const std::vector<TableColumn>& columns, std::vector<double>& row) {
  for (const TableColumn& column : columns) row.push_back(number(point, column.name));
}

std::vector<TableColumn> joined(std::vector<TableColumn> first, const std::vector<TableColumn>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// What every point has.
std::vector<TableColumn> columns_of_point() {
  return joined({{"up", "-", true}, {"found", "-", true}}, condition_columns());
}

/// One row a point.
void write_periodic(ResultsFile& file, const CaseInput& problem, const Summary& results) {
  const AvailableModels given =
      available_models(!problem.dry(), problem.traction, problem.roughness, problem.scales.solids, problem.wear,
                       problem.stress, problem.rating.get());
  std::vector<TableColumn> columns = columns_of_point();
  for (const PeriodQuantity& quantity : period_quantities) {
    if (quantity.of_sweep() && given.has(quantity.needs))
      columns.push_back({std::string(quantity.name), std::string(quantity.unit.name)});
  }
  if (given.friction) columns = joined(columns, {{"mean_friction_coefficient", "-"}, {"efficiency", "-"}});
  if (problem.fatigue) columns = joined(columns, flank_columns());
  columns = joined(columns, orbit_columns());
  std::vector<double> rows;
  for (const Summary& point : results) {
    append_numbers(point, columns, rows);
    add_multipliers_to_row(point.value("floquet", Summary()), rows);
  }
  write_table(file, "/sweep", joined(columns, multiplier_columns()), rows);
}

/// Of marches: one row a march, and in /diagram one row a mesh period that is kept of it.
void write_marches(ResultsFile& file, const CaseInput& problem, const Summary& results) {
  const std::vector<TableColumn> where = joined({{"up", "-", true}}, condition_columns());
  const std::vector<TableColumn> point = joined(columns_of_point(), marched_columns(!problem.dry()));
  std::vector<double> points, sections;
  for (const Summary& result : results) {
    append_numbers(result, point, points);
    if (result.contains("error")) continue;
    for (const Summary& at : result["poincare"]) {
      append_numbers(result, where, sections);
      for (const Summary& value : at) sections.push_back(value.get<double>());
    }
  }
  write_table(file, "/sweep", point, points);
  write_table(file, "/diagram", joined(where, diagram_columns(!problem.dry())), sections);
}

/// The motions that a march repeats, or comes near to; none where it does not settle.
std::vector<Motion> states_of(const Summary& result) {
  if (result.contains("error") || result["settles_on"].is_null()) return {};
  const Summary& all = result["poincare"];
  std::vector<Motion> states;
  for (std::size_t n = all.size() - result["settles_on"].get<std::size_t>(); n + 1 < all.size(); ++n) {
    states.push_back(all[n].get<Motion>());
  }
  states.push_back(result["settles_at"].get<Motion>());
  return states;
}

/// Wherever in its period the other is, of which the last motion is the best known.
bool same_motions(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  constexpr double near = 0.1;  // in (H_0, V_0): marches may still settle
  return a.size() == b.size() &&
         std::ranges::any_of(a, [&](const Motion& motion) { return length(difference(motion, b.back())) < near; });
}

/// The motions on which marches settle, each by the first march that comes there; those that have come to repeat, where
/// any has.
std::vector<const Summary*> attractors_in(const Summary& results) {
  std::vector<const Summary*> attractors;
  const auto gather = [&](const char* evidence) {
    for (const Summary& result : results) {
      if (result.contains("error") || result[evidence].is_null()) continue;
      const auto same = [&](const Summary* known) { return same_motions(states_of(*known), states_of(result)); };
      if (std::ranges::none_of(attractors, same)) attractors.push_back(&result);
    }
  };
  gather("repeats_every");
  if (attractors.empty()) gather("settles_on");
  return attractors;
}

/// Where every start leads: counted from 1, and 0 where the march does not settle on any of them.
std::vector<int> basins_of(const Summary& results, const std::vector<const Summary*>& attractors) {
  std::vector<int> basins;
  for (const Summary& result : results) {
    const std::vector<Motion> states = states_of(result);
    const auto known = std::ranges::find_if(
        attractors, [&](const Summary* of) { return !states.empty() && same_motions(states_of(*of), states); });
    basins.push_back(known == attractors.end() ? 0 : static_cast<int>(known - attractors.begin()) + 1);
  }
  return basins;
}

/// A start of the basins, and the attractor that its march comes to; 0: none.
struct Start {
  const Summary& march;
  int attractor;

  Summary operator[](const char* name) const { return march.value(name, Summary()); }
};

constexpr auto basin_members = std::to_array<Member<Start>>({
    {"H0", "H_0", "-", "rigid displacement at the start", [](const Start& of) { return of["H0"]; }, Column::real},
    {"V0", "V_0", "-", "its velocity there", [](const Start& of) { return of["V0"]; }, Column::real},
    {"attractor", "", "-", "number of the motion that the march comes to, as in the summary; 0: none",
     [](const Start& of) -> Summary { return of.attractor; }, Column::whole},
    {"settles_on", "", "-", "mesh periods after which that repeats", [](const Start& of) { return of["settles_on"]; },
     Column::real},
    {"H0_end", "H_0", "-", "rigid displacement at the end of the march",
     [](const Start& of) { return of["H0_after_leaving"]; }, Column::real},
    {"V0_end", "V_0", "-", "its velocity there", [](const Start& of) { return of["V0_after_leaving"]; }, Column::real},
    {"force_ratio_max", "", "-", "largest force on one contact over the static force",
     [](const Start& of) { return of["force_ratio_max"]; }, Column::real},
});

/// A motion on which marches settle; number 0: what is left.
struct Attractor {
  int number;
  const Summary* march;  ///< that comes to it; null of what is left
  double share;
};

constexpr auto attractor_members = std::to_array<Member<Attractor>>({
    {"attractor", "", "-", "its number, from 1; 0: marches that settle on none",
     [](const Attractor& of) -> Summary { return of.number; }},
    {"repeats_every", "", "-", "mesh periods after which it repeats; null: not known",
     [](const Attractor& of) -> Summary { return of.march ? (*of.march)["settles_on"] : Summary(); }},
    {"force_ratio_max", "", "-", "largest force on one contact over the static force",
     [](const Attractor& of) -> Summary { return of.march ? (*of.march)["force_ratio_max"] : absent(); }},
    {"share", "", "-", "part of the starts that lead there", [](const Attractor& of) -> Summary { return of.share; }},
    {"states_after_leaving", "", "-", "(H0, V0) just after a contact has left, once a mesh period",
     [](const Attractor& of) -> Summary { return of.march ? Summary(states_of(*of.march)) : absent(); }},
});

void write_basins(ResultsFile& file, const Summary& results) {
  const std::vector<int> basins = basins_of(results, attractors_in(results));
  std::vector<double> rows;
  for (std::size_t n = 0; n < basins.size(); ++n) add_to_row(basin_members, Start{results[n], basins[n]}, rows);
  write_table(file, "/basins", columns_of(basin_members), rows);
}

}  // namespace

Summary attractors_of(const Summary& results) {
  const std::vector<const Summary*> attractors = attractors_in(results);
  const std::vector<int> basins = basins_of(results, attractors);
  const auto share = [&](int number) {
    return static_cast<double>(std::ranges::count(basins, number)) / static_cast<double>(basins.size());
  };
  Summary list = Summary::array();
  const auto add = [&](int number, const Summary* march) {
    list.push_back(as_summary(attractor_members, Attractor{number, march, share(number)}));
  };
  for (std::size_t n = 0; n < attractors.size(); ++n) add(static_cast<int>(n) + 1, attractors[n]);
  if (share(0) > 0.0) add(0, nullptr);
  return list;
}

std::string basins_markdown() {
  return members_markdown("`/basins`", "One row a start of `sweep` with `sweep.kind: basins`.", basin_members) +
         members_markdown("Attractors", "Keys of each of the `attractors` in its summary.", attractor_members);
}

std::string description_of(const Summary& attractor) {
  if (attractor["repeats_every"].is_null()) return "does not repeat within the march, or could not be marched";
  std::ostringstream text;
  text.precision(4);
  text << "repeats every " << attractor["repeats_every"].get<int>() << " mesh period(s), force ratio "
       << attractor["force_ratio_max"].get<double>() << ", after leaving";
  for (const Summary& state : attractor["states_after_leaving"]) {
    text << " (" << state[0].get<double>() << ", " << state[1].get<double>() << ")";
  }
  return text.str();
}

void write_sweep_tables(MPI_Comm comm, const CaseInput& problem, const Summary& results) {
  ResultsFile file(comm, problem.run.directory / "results.h5");
  write_identity(file, problem, "sweep");
  switch (problem.sweep.kind) {
    case SweepKind::periodic:
      write_periodic(file, problem, results);
      break;
    case SweepKind::marches:
      write_marches(file, problem, results);
      break;
    case SweepKind::basins:
      write_basins(file, results);
      break;
  }
  file.finish();
}

}  // namespace gearfilm
