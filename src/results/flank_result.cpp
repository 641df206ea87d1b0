#include "results/flank_result.hpp"

#include <algorithm>
#include <cmath>

#include "results/members.hpp"
#include "results/static_passage.hpp"

namespace gearfilm {
namespace {

/// Values of own depths, [point][own depth], of all depths on all processes.
std::vector<double> of_all_depths(MPI_Comm comm, const RowRange& own, std::size_t depths,
                                  const std::vector<double>& values, std::size_t points) {
  std::vector<double> all(points * depths, 0.0);
  const std::size_t count = own.count();
  for (std::size_t n = 0; n < points; ++n) {
    for (std::size_t k = 0; k < count; ++k) all[n * depths + own.begin + k] = values[n * count + k];
  }
  // Zeros but on one process.
  MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM, comm);
  return all;
}

void keep_larger(std::vector<double>& largest, const std::vector<double>& values) {
  if (largest.empty()) largest = values;
  for (std::size_t n = 0; n < values.size(); ++n) largest[n] = std::max(largest[n], values[n]);
}

void keep_larger(FlankMap& largest, const FlankMap& map) {
  keep_larger(largest.dang_van, map.dang_van);
  keep_larger(largest.von_mises, map.von_mises);
  keep_larger(largest.orthogonal_amplitude, map.orthogonal_amplitude);
}

/// Points of a flank that are farther from its ends than the margin.
bool counts(const FatigueModel& fatigue, const Scales& scales, const std::vector<double>& s, std::size_t point) {
  const double margin = fatigue.margin * scales.length;
  return s[point] >= s.front() + margin && s[point] <= s.back() - margin;
}

/// Int ds Int dz/a of one flank [m], by the trapezoidal rule along it.
double risk_of(const MeshModel& mesh, const std::vector<double>& s, const std::vector<double>& amplitudes) {
  const std::vector<double>& depths = mesh.stress->depths;
  const FatigueModel& fatigue = *mesh.fatigue;
  RiskOptions options = fatigue.risk;
  options.threshold *= 1e-9;
  double sum = 0.0;
  for (std::size_t n = 0; n < s.size(); ++n) {
    if (!counts(fatigue, mesh.scales, s, n)) continue;
    std::vector<double> of_point;
    for (std::size_t k = 0; k < depths.size(); ++k) of_point.push_back(1e-9 * amplitudes[n * depths.size() + k]);
    sum += (s[1] - s[0]) * risk_of_depths(depths, of_point, options, fatigue.from_depth);
  }
  return sum;
}

/// Width of the strips [m] for which rows at increasing y stand, each half-way to its neighbours, and as far beyond the
/// outer ones; images included where rows are mirrored. Of a single row: 1.
std::vector<double> shares_of_face(const std::vector<double>& y, bool mirrored) {
  if (y.size() < 2) return {1.0};
  std::vector<double> shares, edges{mirrored ? 0.0 : 1.5 * y[0] - 0.5 * y[1]};
  for (std::size_t row = 0; row + 1 < y.size(); ++row) edges.push_back(0.5 * (y[row] + y[row + 1]));
  edges.push_back(2.0 * y.back() - edges.back());
  for (std::size_t row = 0; row < y.size(); ++row) shares.push_back((mirrored ? 2 : 1) * (edges[row + 1] - edges[row]));
  return shares;
}

/// Judges flanks by histories whose depths the processes share.
class FlankJudge {
public:
  FlankJudge(const Grid& grid, const MeshModel& mesh)
      : comm_(grid.comm()),
        mesh_(mesh),
        depths_(mesh.stress->depths.size()),
        ranges_(cut_evenly(static_cast<int>(depths_), grid.processes())),
        own_{ranges_[grid.rank()], ranges_[grid.rank() + 1]} {
    const RowAxis& axis = grid.row_axis();
    for (const int row : stress_rows(*mesh.stress, axis)) y_.push_back(mesh.scales.length * axis.y(row));
    weights_ = shares_of_face(y_, axis.mirrored());
  }

  const std::vector<double>& y() const { return y_; }

  /// The worst of the passages at each place.
  FlankResult flank(std::size_t body, const std::vector<Passage>& passages) const {
    const FatigueModel& fatigue = *mesh_.fatigue;
    const FlankPath path(mesh_.path.line(), body == pinion_body);
    FlankResult flank;
    flank.s = flank_points(path, fatigue.flank_points);
    const std::vector<double> nothing(flank.s.size() * depths_, 0.0);
    flank.rows.assign(y_.size(), {nothing, nothing, nothing});
    for (const Passage& passage : passages) {
      for (std::size_t row = 0; row < rows_of(passage); ++row) {
        const FlankMap map = flank_map(passage[row][body], flank.s, own_.count(), fatigue.dang_van);
        keep_larger(flank.rows[row], {whole(map.dang_van, flank.s), whole(map.von_mises, flank.s),
                                      whole(map.orthogonal_amplitude, flank.s)});
      }
    }
    for (const FlankMap& row : flank.rows) keep_larger(flank.map, row);
    flank.section = worst_section(comm_, ranges_, passages, body);
    for (std::size_t n = 0; fatigue.has_limit(body) && n < flank.map.dang_van.size(); ++n) {
      const double z = mesh_.scales.length * mesh_.stress->depths[n % depths_];
      flank.safety.push_back(fatigue.safety(body, z, flank.map.dang_van[n]));
    }
    return flank;
  }

  /// Of one passage over a flank.
  double risk(std::size_t body, const Passage& passage, const std::vector<double>& s) const {
    double sum = 0.0;
    for (std::size_t row = 0; row < rows_of(passage); ++row) {
      sum += weights_[row] * risk_of(mesh_, s, whole(orthogonal_amplitudes(passage[row][body], s, own_.count()), s));
    }
    return sum;
  }

private:
  /// Rows at the edges of a grid that has become wider meanwhile carried nothing.
  std::size_t rows_of(const Passage& passage) const { return std::min(passage.size(), y_.size()); }
  std::vector<double> whole(const std::vector<double>& values, const std::vector<double>& s) const {
    return of_all_depths(comm_, own_, depths_, values, s.size());
  }

  MPI_Comm comm_;
  const MeshModel& mesh_;
  std::size_t depths_;
  std::vector<int> ranges_;
  RowRange own_;
  std::vector<double> y_, weights_;  ///< of the rows: place, and what of the face each stands for [m]
};

/// What a flank comes to.
struct Worst {
  std::optional<double> value{};
  double s = 0.0, y = 0.0, z = 0.0;  ///< [m]
};

/// y of the row that is the worst at a place.
double row_of(const FlankResults& all, const FlankResult& flank, std::size_t place) {
  const auto is_worst = [&](const FlankMap& row) { return row.dang_van[place] == flank.map.dang_van[place]; };
  return all.y[std::ranges::find_if(flank.rows, is_worst) - flank.rows.begin()];
}

/// The extreme of values from a depth on, among the points that count.
template <class Better>
Worst extreme(const MeshModel& mesh, const FlankResults& all, const FlankResult& flank,
              const std::vector<double>& values, Better better) {
  Worst worst;
  const std::vector<double>& depths = mesh.stress->depths;
  for (std::size_t n = 0; n < flank.s.size(); ++n) {
    if (!counts(*mesh.fatigue, mesh.scales, flank.s, n)) continue;
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const double value = values[n * depths.size() + k];
      if (depths[k] < mesh.fatigue->from_depth || (worst.value && !better(value, *worst.value))) continue;
      worst = {value, flank.s[n], row_of(all, flank, n * depths.size() + k), all.z[k]};
    }
  }
  return worst;
}

/// Largest value at the surface, among the points that count.
double at_surface(const MeshModel& mesh, const FlankResult& flank) {
  double largest = 0.0;
  for (std::size_t n = 0; n < flank.s.size(); ++n) {
    if (counts(*mesh.fatigue, mesh.scales, flank.s, n)) {
      largest = std::max(largest, flank.map.dang_van[n * mesh.stress->depths.size()]);
    }
  }
  return largest;
}

struct FlankQuantities {
  struct OfBody {
    Worst dang_van, safety;
    std::optional<double> surface{};
  };

  std::array<OfBody, body_count> body{};
  bool followed = false;  ///< a contact over the whole path
  std::optional<double> life_ratio{};
};

FlankQuantities quantities_of(const MeshModel& mesh, const std::optional<FlankResults>& results) {
  FlankQuantities quantities;
  if (!results) return quantities;
  quantities.followed = true;
  for (std::size_t body = 0; body < body_count; ++body) {
    const FlankResult& flank = results->of_body[body];
    FlankQuantities::OfBody& of = quantities.body[body];
    of.dang_van = extreme(mesh, *results, flank, flank.map.dang_van, std::greater());
    of.surface = at_surface(mesh, flank);
    if (!flank.safety.empty()) of.safety = extreme(mesh, *results, flank, flank.safety, std::less());
  }
  quantities.life_ratio = life_ratio(results->risk, results->reference_risk, mesh.fatigue->risk);
  return quantities;
}

Summary place(const Worst& worst, double Worst::*coordinate) {
  return worst.value ? Summary(worst.*coordinate) : Summary();
}

/// Cycles by the slope of ISO's life factor of flanks, from 5e7 on where the safety is 1; null beyond.
Summary cycles_of(const std::optional<double>& safety) {
  constexpr double knee = 5e7, slope = 13.22;
  if (!safety || *safety >= 1.0) return nullptr;
  return knee * std::pow(std::max(*safety, 0.0), slope);
}

template <std::size_t body>
constexpr auto flank_members_of(const std::array<std::string_view, 10>& names) {
  using Of = const FlankQuantities&;
  return std::to_array<Member<FlankQuantities>>({
      {names[0], "DV", "Pa", "largest Dang Van stress below z = 0.05 a, off both ends of the flank",
       [](Of of) -> Summary { return known(of.body[body].dang_van.value); }, Column::real},
      {names[1], "s_i", "m", "where: along the flank from the base circle",
       [](Of of) -> Summary { return place(of.body[body].dang_van, &Worst::s); }},
      {names[2], "z", "m", "its depth", [](Of of) -> Summary { return place(of.body[body].dang_van, &Worst::z); }},
      {names[3], "y", "m", "its row", [](Of of) -> Summary { return place(of.body[body].dang_van, &Worst::y); }},
      {names[4], "DV", "Pa", "the same at the surface, which depends on the grid",
       [](Of of) -> Summary { return known(of.body[body].surface); }, Column::real},
      {names[5], "S_DV", "-",
       "least factor on the stresses of the load at which the limit is met; null without a limit",
       [](Of of) -> Summary { return known(of.body[body].safety.value); }, Column::real},
      {names[6], "s_i", "m", "where: along the flank",
       [](Of of) -> Summary { return place(of.body[body].safety, &Worst::s); }},
      {names[7], "z", "m", "its depth", [](Of of) -> Summary { return place(of.body[body].safety, &Worst::z); }},
      {names[8], "y", "m", "its row", [](Of of) -> Summary { return place(of.body[body].safety, &Worst::y); }},
      {names[9], "N_c", "-", "5e7 S_DV^13.22, the slope of ISO's life factor; null where S_DV is 1 or more: above 5e7",
       [](Of of) -> Summary { return cycles_of(of.body[body].safety.value); }},
  });
}

constexpr auto pinion_members =
    flank_members_of<pinion_body>({"dang_van_max_pinion", "dang_van_s_pinion", "dang_van_z_pinion", "dang_van_y_pinion",
                                   "dang_van_surface_pinion", "safety_dang_van_pinion", "safety_dang_van_s_pinion",
                                   "safety_dang_van_z_pinion", "safety_dang_van_y_pinion", "cycles_dang_van_pinion"});
constexpr auto wheel_members =
    flank_members_of<wheel_body>({"dang_van_max_wheel", "dang_van_s_wheel", "dang_van_z_wheel", "dang_van_y_wheel",
                                  "dang_van_surface_wheel", "safety_dang_van_wheel", "safety_dang_van_s_wheel",
                                  "safety_dang_van_z_wheel", "safety_dang_van_y_wheel", "cycles_dang_van_wheel"});
constexpr auto life_members = std::to_array<Member<FlankQuantities>>({
    {"life_ratio", "", "-",
     "life by Lundberg and Palmgren's risk of both flanks over that of dry contacts of the static load shares; above 1 "
     "where the motion unloads the flanks",
     [](const FlankQuantities& of) -> Summary { return known(of.life_ratio); }, Column::real},
});

}  // namespace

FlankResults flank_results(const Grid& grid, const MeshModel& rest, const std::vector<Passage>& passages) {
  FlankResults results;
  for (const double depth : rest.stress->depths) results.z.push_back(rest.scales.length * depth);
  const FlankJudge judge(grid, rest);
  results.y = judge.y();
  const auto count = static_cast<double>(passages.size());
  for (std::size_t body = 0; body < body_count; ++body) {
    results.of_body[body] = judge.flank(body, passages);
    for (const Passage& passage : passages) results.risk += judge.risk(body, passage, results.of_body[body].s) / count;
  }
  for (const Passage& passage : passages) {
    const Passage at_rest = static_passage(grid, rest, passage);
    for (std::size_t body = 0; body < body_count; ++body) {
      results.reference_risk += judge.risk(body, at_rest, results.of_body[body].s) / count;
    }
  }
  return results;
}

FlankResults flank_results(const OrbitProblem& problem, const SharedDiscretisation& films, const PeriodicOrbit& orbit,
                           const StopCheck& check_stop) {
  const std::vector<Passage> passages = orbit_passages(problem, films, orbit, check_stop);
  return flank_results(Grid(films->grid().comm(), orbit.end.shape), problem.mesh, passages);
}

namespace {

/// Maps of every row, [row][point][depth].
void write_rows(ResultsFile& file, const std::string& group, const FlankResults& results, const FlankResult& flank) {
  const std::array<int, 3> size{static_cast<int>(results.y.size()), static_cast<int>(flank.s.size()),
                                static_cast<int>(results.z.size())};
  const auto write = [&](const char* name, std::vector<double> FlankMap::*values) {
    std::vector<double> all;
    for (const FlankMap& row : flank.rows) all.insert(all.end(), (row.*values).begin(), (row.*values).end());
    file.blocks(group, name, "Pa", size, all);
  };
  file.rows(group, "y_rows", "m", size[0], 1, results.y);
  write("dang_van_rows", &FlankMap::dang_van);
  write("von_mises_rows", &FlankMap::von_mises);
  write("orthogonal_amplitude_rows", &FlankMap::orthogonal_amplitude);
}

/// As a film at rest has it in contact0/section.
void write_section(ResultsFile& file, const std::string& group, const FlankResults& results,
                   const WorstSection& section) {
  const int depths = static_cast<int>(results.z.size()), lines = static_cast<int>(section.x.size());
  file.rows(group, "x", "m", lines, 1, section.x);
  file.rows(group, "z", "m", depths, 1, results.z);
  write_stresses(file, group, "", depths, lines, section.stress);
  file.attribute(group, "xi", section.xi);
  file.attribute(group, "y", results.y[std::min(section.row, results.y.size() - 1)]);
}

}  // namespace

void write_flanks(ResultsFile& file, const FatigueModel& fatigue, const FlankResults& results) {
  const int depths = static_cast<int>(results.z.size());
  for (std::size_t body = 0; body < body_count; ++body) {
    const FlankResult& flank = results.of_body[body];
    const std::string group = body == pinion_body ? "/flank/pinion" : "/flank/wheel";
    const int points = static_cast<int>(flank.s.size());
    file.rows(group, "z", "m", depths, 1, results.z);
    file.rows(group, "dang_van", "Pa", points, depths, flank.map.dang_van);
    file.rows(group, "von_mises_max", "Pa", points, depths, flank.map.von_mises);
    file.rows(group, "orthogonal_amplitude", "Pa", points, depths, flank.map.orthogonal_amplitude);
    if (!flank.safety.empty()) file.rows(group, "safety", "-", points, depths, flank.safety);
    if (results.y.size() > 1) write_rows(file, group, results, flank);
    std::vector<double> hardness, residual;
    for (const double z : results.z) {
      if (fatigue.material[body].has_hardness()) hardness.push_back(fatigue.material[body].hardness(z));
      residual.push_back(fatigue.material[body].residual_stress(z));
    }
    if (!hardness.empty()) file.rows(group, "hardness", "HV", depths, 1, hardness);
    file.rows(group, "residual_stress", "Pa", depths, 1, residual);
    write_section(file, body == pinion_body ? "/section/pinion" : "/section/wheel", results, flank.section);
  }
}

void add_flanks(const MeshModel& mesh, const std::optional<FlankResults>& results, Summary& summary) {
  const FlankQuantities quantities = quantities_of(mesh, results);
  add_members(pinion_members, quantities, summary);
  add_members(wheel_members, quantities, summary);
  add_members(life_members, quantities, summary);
}

std::vector<TableColumn> flank_columns() {
  std::vector<TableColumn> columns = columns_of(pinion_members);
  for (const auto& more : {columns_of(wheel_members), columns_of(life_members)}) {
    columns.insert(columns.end(), more.begin(), more.end());
  }
  return columns;
}

std::string flank_markdown() {
  return members_markdown("Fatigue of the pinion's flank",
                          "With `fatigue.criterion`, in the summaries of `periodic`, of each point of `sweep`, and of "
                          "`transient` by the last contact that was followed over its whole path. Maps over flank and "
                          "depth are in `/flank/pinion` and `/flank/wheel`; with `stress.rows: all` those of each row "
                          "too, as (row, point, depth) in `dang_van_rows`, `von_mises_rows` and "
                          "`orthogonal_amplitude_rows`, the rows at `y_rows`. `/section/pinion` and `/section/wheel` "
                          "have the section below the contact when its von Mises stress is largest.",
                          pinion_members, "`/sweep`") +
         members_markdown("Fatigue of the wheel's flank", "The same of the wheel.", wheel_members, "`/sweep`") +
         members_markdown("Life", "Beside them.", life_members, "`/sweep`");
}

}  // namespace gearfilm
