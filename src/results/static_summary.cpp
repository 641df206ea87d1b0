#include "results/static_summary.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "output/file_ownership.hpp"
#include "results/members.hpp"

namespace gearfilm {
namespace {

constexpr int most_contacts = 3;      // a contact ratio of two and more has as many columns
constexpr double least_share = 1e-3;  // that a table of shares may have

constexpr auto static_members = std::to_array<Member<StaticLoad>>({
    {"te_mean", "", "m", "transmission error, mean over the mesh period",
     [](const StaticLoad& of) -> Summary { return of.length(of.found().mean); }},
    {"te_peak_to_peak", "", "m", "transmission error, largest less smallest",
     [](const StaticLoad& of) -> Summary { return of.length(of.found().peak_to_peak); }},
    {"te_pitch", "", "m", "transmission error with a contact at the pitch point",
     [](const StaticLoad& of) -> Summary { return of.length(-of.found().at_pitch.H0); }},
    {"te_harmonics", "", "m", "amplitudes at the first multiples of the mesh frequency",
     [](const StaticLoad& of) -> Summary {
       Summary all = Summary::array();
       for (double amplitude : of.found().harmonics) all.push_back(of.length(amplitude));
       return all;
     }},
    {"mesh_stiffness_pitch", "", "N/m", "mesh stiffness with a contact at the pitch point",
     [](const StaticLoad& of) -> Summary { return of.stiffness(of.found().at_pitch.stiffness); }},
    {"mesh_stiffness_mean", "", "N/m", "mesh stiffness, mean over the mesh period",
     [](const StaticLoad& of) -> Summary { return of.stiffness(of.found().mean_stiffness); }},
    {"entry_penetration", "", "m", "by which an entering tooth meets its mate; null where none does",
     [](const StaticLoad& of) -> Summary {
       const std::optional<double>& met = of.found().entry_penetration;
       return met ? Summary(of.length(*met)) : Summary();
     }},
    {"corner_contact_distance", "", "m", "how far before the path of contact real tips would touch; null where not",
     [](const StaticLoad& of) -> Summary {
       const double met = of.found().entry_penetration.value_or(0.0);
       return met > 0.0 ? Summary(corner_distance(of.mesh(), met)) : Summary();
     }},
    {"effective_contact_ratio", "", "-", "contacts that carry more than a thousandth of the load, on the average",
     [](const StaticLoad& of) -> Summary { return of.found().effective_contact_ratio; }},
    {"p_max_dry", "", "Pa", "largest Hertz pressure",
     [](const StaticLoad& of) -> Summary { return of.largest_pressure(); }},
});

}  // namespace

Summary StaticLoad::summary() const {
  Summary result;
  add_members(static_members, *this, result);
  return result;
}

std::string StaticLoad::markdown() {
  return members_markdown("The dry pair turned slowly",
                          "Keys of the summary of `static`, of the static load and of each of its `loads`.",
                          static_members);
}

double StaticLoad::largest_pressure() const {
  double highest = 0.0;
  for (const StaticPosition& position : found_.positions) highest = std::max(highest, largest_pressure(position));
  return highest;
}

std::vector<TableColumn> StaticLoad::columns() {
  std::vector<TableColumn> columns = {{"load_ratio", "-"}, {"mesh_period", "-"}, {"xi", "m"},
                                      {"te", "m"},         {"stiffness", "N/m"}, {"p_max_dry", "Pa"}};
  for (int k = 0; k < most_contacts; ++k) columns.push_back({"force_" + std::to_string(k), "N"});
  for (int k = 0; k < most_contacts; ++k) {
    columns.push_back({"gap_" + std::to_string(k), "m"});
    columns.push_back({"compliance_" + std::to_string(k), "m/N"});
  }
  return columns;
}

void StaticLoad::append_rows(double load_ratio, std::vector<double>& rows) const {
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

std::string StaticLoad::shares() const {
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

std::vector<StaticPosition> StaticLoad::every_eighth() const {
  const std::vector<StaticPosition>& all = found_.positions;
  std::vector<StaticPosition> chosen;
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].contacts == all[begin].contacts) ++end;
    const std::size_t last = end - begin - 1, intervals = std::max<std::size_t>(1, last / 8);
    for (std::size_t n = 0; n <= intervals; ++n) chosen.push_back(all[begin + n * last / intervals]);
  }
  return chosen;
}

double StaticLoad::largest_pressure(const StaticPosition& position) const {
  double largest = 0.0;
  for (std::size_t k = 0; k < position.contacts.size(); ++k) {
    if (position.forces[k] <= 0.0) continue;
    const ContactConditions conditions = mesh_.contact(position.contacts[k], position.T).conditions;
    largest = std::max(largest, dry_contact(scales_, conditions, position.forces[k]).pressure);
  }
  return largest;
}

}  // namespace gearfilm
