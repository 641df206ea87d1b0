#include "gearfilm/dynamics/step_record.hpp"

#include <algorithm>

namespace gearfilm {

ContactRecord contact_record(const MeshModel& mesh, int number, double T, const FilmFigures& figures) {
  const MeshedContact contact = mesh.contact(number, T);
  return {number, contact.position, figures_of({mesh.scales, contact, figures})};
}

namespace {

// A step of no length: temperatures stay, and make their friction.
constexpr double moment = 1e-15;  // [s]

// Where sliding begins or ends shear thins the middle of the contact by many decades at once: kappa follows by so much
// a step, and is extrapolated by no more than a quarter of that.
constexpr double largest_shear_step = 4.0, most_shear = 1.0;

/// Of the step to come, as long as the one between these two.
FlowFactors extrapolated(const FlowFactors& before, const FlowFactors& now) {
  FlowFactors next = now;
  for (std::size_t n = 0; n < next.entrainment_excess.size(); ++n) {
    next.log_poiseuille[n] += now.log_poiseuille[n] - before.log_poiseuille[n];
    next.entrainment_excess[n] += now.entrainment_excess[n] - before.entrainment_excess[n];
    next.density_ratio[n] += now.density_ratio[n] - before.density_ratio[n];
    next.shear_index[n] += std::clamp(now.shear_index[n] - before.shear_index[n], -most_shear, most_shear);
    next.cross_flow[n] = std::max(2.0 * now.cross_flow[n] - before.cross_flow[n], 0.5 * now.cross_flow[n]);
  }
  return next;
}

void follow_shear(const FlowFactors& before, FlowFactors& now) {
  for (std::size_t n = 0; n < now.shear_index.size(); ++n) {
    now.shear_index[n] = std::clamp(now.shear_index[n], before.shear_index[n] - largest_shear_step,
                                    before.shear_index[n] + largest_shear_step);
  }
}

TractionFigures traction_of(const MeshModel& mesh, const LiveContact& live, double dT) {
  const TractionModel& model = *mesh.traction;
  if (!live.heat) return traction(model, *live.film).figures;
  LiveHeat& heat = *live.heat;
  if (dT > 0.0) {
    const FlowFactors before = heat.state.flow;
    heat.traction = coupled_traction(model, *live.film, heat.state, dT * mesh.scales.time);
    follow_shear(before, heat.state.flow);
    live.film->set_flow_factors(extrapolated(before, heat.state.flow));
  } else {
    FilmHeat still = heat.state;
    heat.traction = coupled_traction(model, *live.film, still, moment);
  }
  return heat.traction->figures;
}

}  // namespace

std::vector<ContactRecord> contact_records(const MeshModel& mesh, const std::vector<LiveContact>& contacts, double T,
                                           const std::vector<FilmFigures>& figures, double dT) {
  std::vector<ContactRecord> records;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const MeshedContact contact = mesh.contact(contacts[k].number, T);
    ContactMoment at{mesh.scales, contact, figures[k], {}, mesh.roughness};
    if (mesh.traction) {
      at.traction = with_powers_times(mesh.load_factor(), traction_of(mesh, contacts[k], dT));
    }
    records.push_back({contacts[k].number, contact.position, figures_of(at)});
  }
  return records;
}

std::vector<int> numbers_of(const std::vector<LiveContact>& contacts) {
  std::vector<int> numbers(contacts.size());
  std::ranges::transform(contacts, numbers.begin(), &LiveContact::number);
  return numbers;
}

}  // namespace gearfilm
