// `gearfilm static`: the dry pair turned slowly through one mesh period under several loads.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "app/commands.hpp"
#include "app/derived.hpp"
#include "app/hard_entry.hpp"
#include "app/screen_table.hpp"
#include "app/warning.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/gear/iso_stiffness.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "gearfilm/mesh/static_mesh.hpp"
#include "output/file_ownership.hpp"
#include "output/output_directory.hpp"
#include "output/results_table.hpp"

namespace gearfilm {
namespace {

constexpr int most_contacts = 3;      // a contact ratio of two and more has as many columns
constexpr double least_share = 1e-3;  // that a table of shares may have

/// One load in SI.
class LoadResult {
public:
  LoadResult(const MeshModel& mesh, const StaticMesh& found) : mesh_(mesh), scales_(mesh.scales), found_(found) {}

  Summary summary() const {
    Summary result = {{"te_mean", length(found_.mean)},
                      {"te_peak_to_peak", length(found_.peak_to_peak)},
                      {"te_pitch", length(-found_.at_pitch.H0)},
                      {"te_harmonics", Summary::array()},
                      {"mesh_stiffness_pitch", stiffness(found_.at_pitch.stiffness)},
                      {"mesh_stiffness_mean", stiffness(found_.mean_stiffness)}};
    for (double amplitude : found_.harmonics) result["te_harmonics"].push_back(length(amplitude));
    Summary& penetration = result["entry_penetration"];
    if (found_.entry_penetration) penetration = length(*found_.entry_penetration);
    Summary& corner = result["corner_contact_distance"];
    if (found_.entry_penetration.value_or(0.0) > 0.0) corner = corner_distance(mesh_, *found_.entry_penetration);
    result["effective_contact_ratio"] = found_.effective_contact_ratio;
    double highest = 0.0;
    for (const StaticPosition& position : found_.positions) highest = std::max(highest, largest_pressure(position));
    result["p_max_dry"] = highest;
    return result;
  }

  void append_rows(double load_ratio, std::vector<double>& rows) const {
    for (const StaticPosition& position : found_.positions) {
      rows.insert(rows.end(), {load_ratio, position.T / mesh_.path.mesh_period(),
                               mesh_.path.position(position.contacts.front(), position.T), length(-position.H0),
                               stiffness(position.stiffness), largest_pressure(position)});
      for (std::size_t k = 0; k < most_contacts; ++k) {
        const bool there = k < position.contacts.size();
        rows.push_back(there ? scales_.force(position.forces[k]) : 0.0);
      }
      for (std::size_t k = 0; k < most_contacts; ++k) {
        const bool there = k < position.contacts.size();
        const double xi = there ? mesh_.path.position(position.contacts[k], position.T) : 0.0;
        rows.push_back(there ? mesh_.teeth.gap(position.contacts[k], xi) : std::nan(""));
        rows.push_back(there ? mesh_.teeth.compliance(xi) : std::nan(""));
      }
    }
  }

  /// xi [m] and share of one contact, from its entering to its leaving.
  std::string shares() const {
    const LineOfAction& line = mesh_.path.line();
    std::vector<std::pair<double, double>> points;
    const std::vector<StaticPosition> chosen = every_eighth();
    // The last contact first: where one period's end meets the next one's begin, that is the order in time.
    for (std::size_t behind = most_contacts; behind-- > 0;) {
      for (const StaticPosition& position : chosen) {
        if (behind >= position.contacts.size()) continue;
        double sum = 0.0;
        for (double force : position.forces) sum += force;
        const double xi = mesh_.path.position(position.contacts[behind], position.T);
        points.emplace_back(std::clamp(xi, line.entry(), line.exit()),
                            std::max(least_share, position.forces[behind] / sum));
      }
    }
    std::ostringstream text;
    text << shares_head << ", for load_sharing.file; at least " << least_share << "\n" << std::setprecision(10);
    for (const auto& [xi, share] : points) text << xi << " " << share << "\n";
    return text.str();
  }

private:
  /// Equally spaced between events, both sides of which stay: a jump of the share needs room behind it.
  std::vector<StaticPosition> every_eighth() const {
    const std::vector<StaticPosition>& all = found_.positions;
    std::vector<StaticPosition> chosen;
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
      while (end < all.size() && all[end].contacts == all[begin].contacts) ++end;
      const std::size_t last = end - begin - 1, intervals = std::max<std::size_t>(1, last / 8);
      for (std::size_t n = 0; n <= intervals; ++n) chosen.push_back(all[begin + n * last / intervals]);
    }
    return chosen;
  }

  double length(double H) const { return scales_.thickness * H; }
  double stiffness(double K) const { return scales_.force(K) / scales_.thickness; }

  double largest_pressure(const StaticPosition& position) const {
    double largest = 0.0;
    for (std::size_t k = 0; k < position.contacts.size(); ++k) {
      if (position.forces[k] <= 0.0) continue;
      const ContactConditions conditions = mesh_.contact(position.contacts[k], position.T).conditions;
      largest = std::max(largest, dry_contact(scales_, conditions, position.forces[k]).pressure);
    }
    return largest;
  }

  const MeshModel& mesh_;
  const Scales& scales_;
  const StaticMesh& found_;
};

void write_table(MPI_Comm comm, const Case& problem, const std::vector<double>& rows) {
  std::vector<TableColumn> columns = {{"load_ratio", "-"}, {"mesh_period", "-"}, {"xi", "m"},
                                      {"te", "m"},         {"stiffness", "N/m"}, {"p_max_dry", "Pa"}};
  for (int k = 0; k < most_contacts; ++k) columns.push_back({"force_" + std::to_string(k), "N"});
  for (int k = 0; k < most_contacts; ++k) {
    columns.push_back({"gap_" + std::to_string(k), "m"});
    columns.push_back({"compliance_" + std::to_string(k), "m/N"});
  }
  ResultsFile file(comm, problem.run.directory / "results.h5");
  write_identity(file, problem, "static");
  write_table(file, "/static", columns, rows);
  file.finish();
}

void print_line(MPI_Comm comm, double ratio, const Summary& at) {
  const auto um = [&](const char* name) { return 1e6 * at[name].get<double>(); };
  const std::string met =
      at["entry_penetration"].is_null() ? "-" : worded(std::fixed, std::setprecision(3), um("entry_penetration"));
  say(comm, std::fixed, std::setw(10), std::setprecision(3), ratio, std::setw(12), um("te_mean"), std::setw(14),
      um("te_peak_to_peak"), std::setw(16), std::setprecision(1), 1e-6 * at["mesh_stiffness_mean"].get<double>(),
      std::setw(16), met, std::setw(14), std::setprecision(4), at["effective_contact_ratio"].get<double>());
}

}  // namespace

void run_static(MPI_Comm comm, const Case& problem) {
  if (!problem.pair.line) throw InputError(problem.parameters.file() + ": a bare contact has no mesh to be turned");
  require_tooth_force(problem, "static");
  const MeshModel mesh = mesh_after_leaving(problem);
  const OutputDirectory directory(comm, problem.run.directory);
  Summary summary = {{"case", problem.name}, {"static_force", problem.scales.operation.load}};
  Summary loads = Summary::array();
  std::vector<double> rows;
  say(comm, "load ratio  TE mean um  peak-peak um  stiffness N/um  entry meets um  contacts");
  const auto add = [&](double ratio) {
    const StaticMesh found = turn_slowly(mesh, ratio * mesh.scales.static_force, problem.statics.positions);
    const LoadResult result(mesh, found);
    Summary at = result.summary();
    result.append_rows(ratio, rows);
    print_line(comm, ratio, at);
    if (ratio == 1.0) write_whole(comm, directory.path() / shares_name, result.shares());
    return at;
  };
  Summary nominal;
  for (double ratio : problem.statics.load_ratios) {
    Summary at = add(ratio);
    if (ratio == 1.0) nominal = at;
    at["load_ratio"] = ratio;
    loads.push_back(std::move(at));
  }
  if (nominal.is_null()) nominal = add(1.0);
  summary.update(nominal);
  summary["loads"] = std::move(loads);
  const IsoStiffness iso = iso_stiffness(*problem.pair.gears, problem.pair.line->contact_ratio());
  summary["iso_stiffness_single"] = iso.single;
  summary["iso_stiffness_mesh"] = iso.mesh;
  write_table(comm, problem, rows);
  write_summary(comm, directory.path(), summary);
  ScreenTable(summary).print(comm, directory.path());
  warn_of_hard_entry(comm, mesh);
}

}  // namespace gearfilm
