#include "results/orbit_summary.hpp"

#include <cmath>
#include <numbers>

#include "results/error_bar.hpp"
#include "results/friction_summary.hpp"
#include "results/march_summary.hpp"
#include "results/members.hpp"

namespace gearfilm {

namespace {

/// Multipliers of a motion of the pair, and the free oscillation that they mean.
struct PairMultipliers {
  PairMultipliers(const MeshModel& mesh, const Multipliers& pair)
      : all(pair),
        modulus(largest_modulus(pair)),
        oscillation(mesh.train
                        ? std::nullopt
                        : free_oscillation(pair, mesh.mesh_frequency_si() / mesh.periods(), mesh.frequency_si())) {}

  const Multipliers& all;
  double modulus;
  std::optional<FreeOscillation> oscillation;
};

constexpr auto multiplier_members = std::to_array<Member<PairMultipliers>>({
    {"floquet", "mu", "-", "Floquet multipliers of the motion, real and imaginary part each",
     [](const PairMultipliers& of) -> Summary { return of.all; }},
    {"floquet_modulus", "abs(mu)", "-", "what a disturbance keeps over the period",
     [](const PairMultipliers& of) -> Summary { return of.modulus; }, Column::real},
    {"stable", "", "", "whether disturbances die away: floquet_modulus below 1",
     [](const PairMultipliers& of) -> Summary { return of.modulus < 1.0; }, Column::real},
    {"free_frequency", "", "Hz", "free oscillation about the periodic state",
     [](const PairMultipliers& of) -> Summary {
       return of.oscillation ? Summary(of.oscillation->frequency) : Summary();
     },
     Column::real},
    {"damping_ratio", "zeta", "-", "damping ratio of the free oscillation",
     [](const PairMultipliers& of) -> Summary {
       return of.oscillation ? Summary(of.oscillation->damping_ratio) : Summary();
     },
     Column::real},
});

/// A periodic state of a pair.
struct OrbitOfPair {
  const MeshModel& mesh;
  const DescribedOrbit& found;

  bool lubricated() const { return !found.orbit.end.films.empty(); }
};

constexpr auto search_members = std::to_array<Member<OrbitOfPair>>({
    {"periods_used", "", "-", "mesh periods marched to find the state",
     [](const OrbitOfPair& of) -> Summary { return of.found.orbit.periods_used; }, Column::real},
    {"final_grid", "", "", "nodes and bounds of the grid at the end, widened or not; not in the dry model",
     [](const OrbitOfPair& of) -> Summary {
       return of.lubricated() ? grid_summary(of.mesh.scales, of.found.orbit.end.shape) : absent();
     }},
    {"defect", "", "-", "change of the motion over the periodic period",
     [](const OrbitOfPair& of) -> Summary { return of.found.orbit.defect; }, Column::real},
    {"film_defect", "", "-",
     "largest change of any pressure over the periodic period, in units of p_h (of films that feel their heat: root "
     "mean square of a field over its largest value)",
     [](const OrbitOfPair& of) -> Summary { return of.lubricated() ? Summary(of.found.orbit.film_defect) : absent(); },
     Column::real},
    {"states_after_leaving", "", "-", "(H0, V0) just after a contact has left, once a mesh period of the state",
     [](const OrbitOfPair& of) -> Summary { return of.found.states_after_leaving; }},
    {"H0_after_leaving", "H_0", "-", "H_0 just after a contact has left",
     [](const OrbitOfPair& of) -> Summary { return of.found.orbit.start.motion.H0(); }, Column::real},
    {"V0_after_leaving", "V_0", "-", "V_0 just after a contact has left",
     [](const OrbitOfPair& of) -> Summary { return of.found.orbit.start.motion.V0(); }, Column::real},
});

constexpr auto swing_members = std::to_array<Member<OrbitOfPair>>({
    {"contact_lost", "", "", "whether the total force falls below 0.02 of the static force",
     [](const OrbitOfPair& of) -> Summary { return of.found.contact_lost; }, Column::real},
    {"back_contact", "", "", "whether reverse flanks touch",
     [](const OrbitOfPair& of) -> Summary { return of.found.quantities["back_force_ratio_max"].value_or(0.0) > 0.0; }},
    {"transmission_error_peak_to_peak", "", "m", "transmission error, largest less smallest",
     [](const OrbitOfPair& of) -> Summary {
       return of.mesh.scales.thickness * of.found.transmission_error.peak_to_peak;
     },
     Column::real},
    {"transmission_error_rms", "", "m", "transmission error, root mean square of its deviation from the mean",
     [](const OrbitOfPair& of) -> Summary {
       return of.mesh.scales.thickness * of.found.transmission_error.root_mean_square;
     },
     Column::real},
});

/// zeta = L/hypot(L, theta) of the logarithm L of the modulus and the angle theta in a period, by the error of L.
double damping_ratio_error(const OrbitOfPair& of, const FreeOscillation& oscillation) {
  const FreeDecay& decay = *of.found.decay;
  const double theta = 2.0 * std::numbers::pi * oscillation.frequency * of.mesh.periods() / of.mesh.mesh_frequency_si();
  const double undamped = 1.0 - oscillation.damping_ratio * oscillation.damping_ratio;
  return decay.modulus_error() / largest_modulus(decay.multipliers) * std::pow(undamped, 1.5) / theta;
}

constexpr auto decay_members = std::to_array<Member<OrbitOfPair>>({
    {"floquet_modulus_error", "", "-", "error of floquet_modulus",
     [](const OrbitOfPair& of) -> Summary {
       return of.found.decay ? Summary(of.found.decay->modulus_error()) : absent();
     },
     Column::real},
    {"damping_ratio_error", "", "-", "error of damping_ratio by that of floquet_modulus",
     [](const OrbitOfPair& of) -> Summary {
       if (!of.found.decay) return absent();
       const std::optional<FreeOscillation> oscillation =
           PairMultipliers(of.mesh, of.found.decay->multipliers).oscillation;
       return oscillation ? Summary(damping_ratio_error(of, *oscillation)) : Summary();
     },
     Column::real},
});

}  // namespace

void add_multipliers(const MeshModel& mesh, const Multipliers& pair, Summary& summary) {
  add_members(multiplier_members, PairMultipliers(mesh, pair), summary);
}

Summary orbit_summary(const MeshModel& mesh, const DescribedOrbit& found) {
  const OrbitOfPair orbit{mesh, found};
  Summary summary;
  add_members(search_members, orbit, summary);
  summary.update(period_summary(mesh.scales, found.quantities));
  add_members(swing_members, orbit, summary);
  if (found.decay) add_multipliers(mesh, found.decay->multipliers, summary);
  add_members(decay_members, orbit, summary);
  return summary;
}

std::vector<TableColumn> orbit_columns() {
  std::vector<TableColumn> columns = columns_of(swing_members);
  for (const auto& more : {columns_of(search_members), columns_of(multiplier_members), columns_of(decay_members)})
    columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

std::vector<TableColumn> multiplier_columns() {
  return {{"floquet_1_re", "-"}, {"floquet_1_im", "-"}, {"floquet_2_re", "-"}, {"floquet_2_im", "-"}};
}

void add_multipliers_to_row(const Summary& floquet, std::vector<double>& row) {
  for (int n = 0; n < 4; ++n) row.push_back(floquet.is_null() ? in_row(floquet) : in_row(floquet[n / 2][n % 2]));
}

std::string orbit_markdown() {
  return members_markdown(
             "A periodic state",
             "Keys of the summary of `periodic` and of each point of `sweep`, beside the quantities of its "
             "period.",
             search_members, "`/sweep`") +
         members_markdown("Its swing", "Likewise.", swing_members, "`/sweep`") +
         members_markdown("Its multipliers", "Likewise; of `eigen` and of the dry pair's orbit too.",
                          multiplier_members, "`/sweep`") +
         members_markdown("How well they are known", "Likewise.", decay_members, "`/sweep`");
}

void add_errors(const std::vector<OrbitError>& errors, const Scales& scales, Summary& summary) {
  for (const OrbitError& error : errors) add_error_bar(summary, error.name, error.in_si(scales));
}

Summary periodic_summary(const CaseInput& problem, const MeshModel& mesh, const FoundOrbit& found,
                         const std::vector<OrbitError>& errors) {
  Summary summary = {{"case", problem.name}};
  summary["motion"] = problem.parameters.text("motion");
  summary["order"] = problem.search.order;
  add_run(problem, mesh, summary);
  summary.update(orbit_summary(mesh, found.own));
  add_errors(errors, mesh.scales, summary);
  add_efficiency(mesh, summary);
  return summary;
}

Summary dry_summary(const MeshModel& mesh) {
  constexpr double most_oscillations = 10.0;
  if (mesh.inertia == 0.0 || mesh.periods() > 1 || mesh.frequency() * mesh.path.mesh_period() > most_oscillations)
    return nullptr;
  const std::optional<DryOrbit> dry = undamped_dry_orbit(mesh);
  if (!dry) return nullptr;
  Summary summary = {{"H0_after_leaving", dry->start.H0()},
                     {"V0_after_leaving", dry->start.V0()},
                     {"force_ratio_max", dry->largest_integral / mesh.scales.static_force}};
  add_multipliers(mesh, multipliers(dry->monodromy), summary);
  for (const char* noise : {"stable", "damping_ratio"}) summary.erase(noise);  // without damping
  return summary;
}

}  // namespace gearfilm
