#include "gearfilm/dynamics/warm_contact.hpp"

namespace gearfilm {
namespace {

/// A stationary film.
ContactFields still(std::vector<double> pressure) {
  std::vector<double> rate(pressure.size(), 0.0);
  ContactFields fields;
  fields.emplace(field::pressure.name, std::move(pressure));
  fields.emplace(field::rate.name, std::move(rate));
  return fields;
}

}  // namespace

LiveContact begin_contact(const MeshModel& mesh, int number, ContactFilm* film, const LoadCondition& load,
                          const SolverOptions& options, StationaryResult& found) {
  if (!corrects_films(mesh)) return {number, film, still(found.solution.pressure), {}};
  CoupledFilm heated = solve_coupled(*film, load, options, *mesh.traction, found);
  found = std::move(heated.film);
  LiveContact contact{number, film, still(found.solution.pressure), {}};
  keep_heat(*mesh.traction, heated.heat, film->grid().y_count(), contact.fields);
  take_up_heat(mesh, contact);
  return contact;
}

void take_up_heat(const MeshModel& mesh, LiveContact& contact) {
  if (!corrects_films(mesh)) return;
  contact.heat =
      std::make_shared<LiveHeat>(LiveHeat{kept_heat(*mesh.traction, contact.fields, contact.film->grid().y_count())});
  contact.film->set_flow_factors(contact.heat->state.flow);
}

void put_down_heat(const MeshModel& mesh, LiveContact& contact) {
  if (!contact.heat) return;
  keep_heat(*mesh.traction, contact.heat->state, contact.film->grid().y_count(), contact.fields);
  take_up_heat(mesh, contact);
}

}  // namespace gearfilm
