#include "results/sweep_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "dynamics/period_figures.hpp"
#include "input/case_setup.hpp"
#include "output/results_table.hpp"
#include "output/run_identity.hpp"
#include "results/derived.hpp"
#include "results/orbit_summary.hpp"
#include "results/sweep_point.hpp"

namespace gearfilm {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Of a point, under the name of a column; absent where a point that failed lacks it.
double number(const Summary& point, const std::string& name) {
  if (name == "up") return point["direction"] == "up" ? 1.0 : 0.0;
  if (name == "found") return point.contains("error") ? 0.0 : 1.0;
  const auto found = point.find(name);
  if (found == point.end() || found->is_null()) return no_value;
  return found->is_boolean() ? static_cast<double>(found->get<bool>()) : found->get<double>();
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
  const Given given = given_figures(!problem.dry(), problem.traction, problem.roughness);
  std::vector<TableColumn> columns = columns_of_point();
  for (const PeriodFigure& figure : period_figures) {
    if (figure.of_sweep() && given.has(figure.needs))
      columns.push_back({std::string(figure.name), std::string(figure.unit.name)});
  }
  columns = joined(columns, orbit_columns());
  std::vector<double> rows;
  for (const Summary& point : results) {
    append_numbers(point, columns, rows);
    for (int n = 0; n < 4; ++n) {
      rows.push_back(point.contains("floquet") ? point["floquet"][n / 2][n % 2].get<double>() : no_value);
    }
  }
  write_table(
      file, "/sweep",
      joined(columns, {{"floquet_1_re", "-"}, {"floquet_1_im", "-"}, {"floquet_2_re", "-"}, {"floquet_2_im", "-"}}),
      rows);
}

/// Of marches: one row a march, and in /diagram one row a mesh period that is kept of it.
void write_marches(ResultsFile& file, const CaseInput& problem, const Summary& results) {
  const std::vector<TableColumn> where = {{"up", "-", true}, {"speed_rpm", "rpm"}, {"torque", "N m"}, {"m_ge", "kg"}};
  std::vector<TableColumn> point = joined(columns_of_point(), {{"H0_after_leaving", "-"},
                                                               {"V0_after_leaving", "-"},
                                                               {"force_ratio_max", "-"},
                                                               {"total_force_ratio_min", "-"},
                                                               {"contact_lost", "-"},
                                                               {"settles_on", "-"}});
  std::vector<TableColumn> section =
      joined(where, {{"H0", "-"}, {"V0", "-"}, {"force_ratio_max", "-"}, {"total_force_ratio_min", "-"}});
  if (!problem.dry()) {
    point.push_back({"h_min", "m"});
    section.push_back({"h_min", "m"});
  }
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
  write_table(file, "/diagram", section, sections);
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

void write_basins(ResultsFile& file, const Summary& results) {
  const std::vector<const Summary*> attractors = attractors_in(results);
  const std::vector<int> basins = basins_of(results, attractors);
  std::vector<double> rows;
  for (std::size_t n = 0; n < basins.size(); ++n) {
    const Summary& result = results[n];
    rows.insert(rows.end(), {number(result, "H0"), number(result, "V0"), static_cast<double>(basins[n]),
                             number(result, "settles_on"), number(result, "H0_after_leaving"),
                             number(result, "V0_after_leaving"), number(result, "force_ratio_max")});
  }
  write_table(file, "/basins",
              {{"H0", "-"},
               {"V0", "-"},
               {"attractor", "-", true},
               {"settles_on", "-"},
               {"H0_end", "-"},
               {"V0_end", "-"},
               {"force_ratio_max", "-"}},
              rows);
}

}  // namespace

Summary attractors_of(const Summary& results) {
  const std::vector<const Summary*> attractors = attractors_in(results);
  const std::vector<int> basins = basins_of(results, attractors);
  const auto share = [&](int number) {
    return static_cast<double>(std::ranges::count(basins, number)) / static_cast<double>(basins.size());
  };
  Summary list = Summary::array();
  for (std::size_t n = 0; n < attractors.size(); ++n) {
    const Summary& found = *attractors[n];
    Summary entry = {{"attractor", n + 1},
                     {"repeats_every", found["settles_on"]},
                     {"force_ratio_max", found["force_ratio_max"]},
                     {"share", share(static_cast<int>(n) + 1)}};
    entry["states_after_leaving"] = states_of(found);
    list.push_back(std::move(entry));
  }
  if (share(0) > 0.0) list.push_back({{"attractor", 0}, {"repeats_every", nullptr}, {"share", share(0)}});
  return list;
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
