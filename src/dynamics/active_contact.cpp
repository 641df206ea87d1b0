#include "dynamics/active_contact.hpp"

#include <algorithm>

namespace gearfilm {
namespace {

std::shared_ptr<StressRecorder> stress_recorder(const MeshModel& mesh) {
  return mesh.stress ? std::make_shared<StressRecorder>(*mesh.stress) : nullptr;
}

}  // namespace

ActiveContact begin_contact(const MeshModel& mesh, int number, ContactFilm* film, const LoadCondition& load,
                            const SolverOptions& options, StationaryResult& found) {
  ActiveContact contact{number, film, {}, film_processes(mesh), stress_recorder(mesh)};
  for (const auto& process : contact.processes) process->begin(*film, load, options, found);
  const std::vector<double>& pressure = found.solution.pressure;
  contact.fields.emplace(field::pressure.name, pressure);
  contact.fields.emplace(field::rate.name, std::vector<double>(pressure.size(), 0.0));
  save_processes(contact);
  return contact;
}

ActiveContact continue_contact(const MeshModel& mesh, int number, ContactFilm* film, ContactFields fields) {
  ActiveContact contact{number, film, std::move(fields), film_processes(mesh), stress_recorder(mesh)};
  restore_processes(contact);
  return contact;
}

void restore_processes(ActiveContact& contact) {
  for (const auto& process : contact.processes) process->restore(*contact.film, contact.fields);
  if (contact.stress) contact.stress->begin_anew();
}

void save_processes(ActiveContact& contact) {
  for (const auto& process : contact.processes) process->save(contact.film->grid(), contact.fields);
  restore_processes(contact);
}

std::shared_ptr<const Traction> traction_of(const TractionModel& model, const ActiveContact& contact) {
  for (const auto& process : contact.processes) {
    if (auto known = process->traction(*contact.film)) return known;
  }
  return std::make_shared<Traction>(traction(model, *contact.film));
}

std::shared_ptr<const Traction> friction_of_step(const TractionModel& model, const ActiveContact& contact, double T) {
  StepFriction& friction = *contact.friction;
  if (friction.T != T) friction = {T, traction_of(model, contact)};
  return friction.known;
}

std::vector<int> numbers_of(const std::vector<ActiveContact>& contacts) {
  std::vector<int> numbers(contacts.size());
  std::ranges::transform(contacts, numbers.begin(), &ActiveContact::number);
  return numbers;
}

}  // namespace gearfilm
