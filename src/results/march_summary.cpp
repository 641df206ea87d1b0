#include "results/march_summary.hpp"

#include <algorithm>

#include "results/friction_summary.hpp"
#include "results/members.hpp"
#include "results/tilt_summary.hpp"

namespace gearfilm {
namespace {

/// One quantity over all the periods that have it.
Summary over_periods(const Summary& periods, const PeriodQuantity& quantity) {
  Summary kept;
  double sum = 0.0;
  int count = 0;
  for (const Summary& period : periods) {
    const auto found = period.find(quantity.name);
    if (found == period.end()) continue;
    if (quantity.reduction == Reduction::mean) {
      sum += found->get<double>();
      kept = sum / ++count;
      continue;
    }
    const bool replaces = kept.is_null() || quantity.reduction == Reduction::last ||
                          (quantity.reduction == Reduction::largest ? *found > kept : *found < kept);
    if (replaces) kept = *found;
  }
  return kept;
}

}  // namespace

Summary period_summary(const Scales& scales, const PeriodQuantities& period) {
  Summary summary;
  for (std::size_t n = 0; n < period_quantities.size(); ++n) {
    if (!period.values[n]) continue;
    const PeriodQuantity& quantity = period_quantities[n];
    const double value = quantity.unit.in_si(scales, *period.values[n]);
    Summary& entry = summary[std::string(quantity.name)];
    if (quantity.unit.whole) {
      entry = static_cast<long>(value);
    } else {
      entry = value;
    }
  }
  return summary;
}

Summary grid_summary(const Scales& scales, const GridShape& shape) {
  return {{"nx", shape.nx},
          {"ny", shape.ny()},
          {"x_min", shape.x_min},
          {"x_max", shape.x_max},
          {"y_half", scales.hertz.ellipticity * shape.row_axis.half_width()}};
}

namespace {

struct RunOfPair {
  const CaseInput& problem;
  const MeshModel& mesh;
};

/// What happens in a march.
struct EventOfPair {
  const MeshModel& mesh;
  const MeshEvent& event;
};

constexpr auto event_members = std::to_array<Member<EventOfPair>>({
    {"event", "", "", "entry or exit of a contact",
     [](const EventOfPair& of) -> Summary { return of.event.kind == MeshEvent::Kind::exit ? "exit" : "entry"; }},
    {"contact", "", "-", "number of the contact, 0 for the leading one at the start",
     [](const EventOfPair& of) -> Summary { return of.event.contact; }},
    {"T", "T", "-", "time in units of a/u_m*", [](const EventOfPair& of) -> Summary { return of.event.T; }},
    {"distance", "", "m", "way along the line of action since the start",
     [](const EventOfPair& of) -> Summary { return of.mesh.path.distance(of.event.T); }},
    {"H0", "H_0", "-", "rigid displacement", [](const EventOfPair& of) -> Summary { return of.event.motion.H0(); }},
    {"V0", "V_0", "-", "its velocity", [](const EventOfPair& of) -> Summary { return of.event.motion.V0(); }},
});

struct LossOfPair {
  const MeshModel& mesh;
  const ContactLoss& loss;
  bool lubricated;
};

constexpr auto loss_members = std::to_array<Member<LossOfPair>>({
    {"distance", "", "m", "way along the line of action where contact is lost",
     [](const LossOfPair& of) -> Summary { return of.mesh.path.distance(of.loss.begin); }},
    {"distance_end", "", "m", "way along the line of action where contact is found again",
     [](const LossOfPair& of) -> Summary { return of.mesh.path.distance(of.loss.end); }},
    {"largest_h_central", "", "m", "largest central film in between; not in the dry model",
     [](const LossOfPair& of) -> Summary {
       return of.lubricated ? Summary(of.mesh.scales.thickness * of.loss.largest_central_film) : absent();
     }},
});

constexpr auto run_members = std::to_array<Member<RunOfPair>>({
    {"nx", "", "-", "nodes in X at the beginning",
     [](const RunOfPair& of) -> Summary { return of.problem.numerics.nx; }},
    {"ny", "", "-", "nodes in Y at the beginning",
     [](const RunOfPair& of) -> Summary { return of.problem.numerics.ny; }},
    {"dT", "dT", "-", "time step over a/u_m",
     [](const RunOfPair& of) -> Summary { return of.problem.numerics.steps.dT; }},
    {"static_force", "w*", "N", "static force on the pair",
     [](const RunOfPair& of) -> Summary { return of.mesh.scales.operation.load; }},
    {"mesh_period", "", "s", "time from one tooth to the next",
     [](const RunOfPair& of) -> Summary { return of.mesh.scales.time * of.mesh.path.mesh_period(); }},
});

}  // namespace

void add_run(const CaseInput& problem, const MeshModel& mesh, Summary& summary) {
  add_members(run_members, RunOfPair{problem, mesh}, summary);
  add_tilt(problem, summary);
}

std::string run_markdown() {
  return members_markdown("What `transient` and `periodic` begin with", "Keys of their summaries.", run_members) +
         members_markdown("Events of a march", "Keys of each of the `events` of `transient`.", event_members) +
         members_markdown("Losses of contact", "Keys of each of the `contact_losses` of `transient`.", loss_members);
}

Summary march_summary(const CaseInput& problem, const MeshModel& mesh, const MarchStatistics& statistics) {
  const Scales& scales = mesh.scales;
  Summary summary = {{"case", problem.name}, {"model", problem.parameters.text("model")}};
  if (problem.march.model == MarchModel::dynamic) summary["motion"] = problem.parameters.text("motion");
  add_run(problem, mesh, summary);
  Summary periods = Summary::array();
  for (const PeriodQuantities& period : statistics.periods()) periods.push_back(period_summary(scales, period));
  for (const PeriodQuantity& quantity : period_quantities) {
    if (!quantity.of_march()) continue;
    if (const Summary value = over_periods(periods, quantity); !value.is_null())
      summary[std::string(quantity.name)] = value;
  }
  add_efficiency(mesh, summary);
  summary["periods"] = std::move(periods);
  summary["events"] = Summary::array();
  for (const MeshEvent& event : statistics.events())
    summary["events"].push_back(as_summary(event_members, EventOfPair{mesh, event}));
  summary["back_contact"] = std::ranges::any_of(statistics.periods(), [](const PeriodQuantities& period) {
    return period["back_force_ratio_max"].value_or(0.0) > 0.0;
  });
  summary["contact_losses"] = Summary::array();
  for (const ContactLoss& loss : statistics.losses())
    summary["contact_losses"].push_back(as_summary(loss_members, LossOfPair{mesh, loss, !problem.dry()}));
  return summary;
}

}  // namespace gearfilm
