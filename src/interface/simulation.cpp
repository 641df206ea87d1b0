#include "gearfilm/simulation.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "dynamics/march_statistics.hpp"
#include "dynamics/pair_march.hpp"
#include "gearfilm/error.hpp"
#include "input/case_setup.hpp"
#include "interface/step_view.hpp"
#include "interface/views.hpp"
#include "results/march_summary.hpp"

namespace gearfilm {

struct ContactInStep::View {
  Scales scales;
  ContactRecord record;
  AvailableModels given;    ///< which quantities there are
  const ContactFilm* film;  ///< borrowed; null in the dry model
};

int ContactInStep::number() const { return view_->record.number; }
double ContactInStep::position() const { return view_->record.position; }

double ContactInStep::value(const std::string& name) const {
  for (std::size_t n = 0; n < contact_quantities.size(); ++n) {
    if (contact_quantities[n].name == name && view_->given.has(contact_quantities[n].needs))
      return contact_quantities[n].unit.in_si(view_->scales, view_->record.quantities.values[n]);
  }
  throw std::out_of_range("contacts of this case have no quantity '" + name + "'");
}

bool ContactInStep::has_film() const { return view_->film != nullptr; }

Film ContactInStep::film() const {
  if (!has_film()) throw std::logic_error("a contact of the dry model has no film");
  return film_of(std::shared_ptr<const ContactFilm>(std::shared_ptr<void>(), view_->film));
}

double Step::total_force() const {
  double sum = 0.0;
  for (const ContactInStep& contact : contacts) sum += contact.value("force");
  return sum;
}

Step step_of(const MeshModel& mesh, const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  const Scales& scales = mesh.scales;
  Step step{scales.time * record.T, scales.time * record.dT, record.motion.H0(), record.motion.V0(), {}};
  const AvailableModels given = available_models(mesh, !contacts.empty() || record.contacts.empty());
  for (const ContactRecord& contact : record.contacts) {
    const auto live = std::ranges::find(contacts, contact.number, &ActiveContact::number);
    const ContactFilm* film = live == contacts.end() ? nullptr : live->film;
    step.contacts.emplace_back(
        std::make_shared<const ContactInStep::View>(ContactInStep::View{scales, contact, given, film}));
  }
  return step;
}

struct Simulation::March {
  March(MPI_Comm comm, const Case& of, Observer watching)
      : input(of.input()),
        observer(std::move(watching)),
        mesh(mesh_model(input, input.march.start_position, input.march.geometry, input.march.course)),
        statistics(mesh.path.mesh_period(), mesh.scales.static_force, mesh.path.course()) {
    const auto on_step = [this](const StepRecord& record, const std::vector<ActiveContact>& contacts) {
      statistics.add(record, available_models(mesh, !input.dry()));
      if (observer) observer(step_of(mesh, record, contacts));
    };
    const QuietErrors quiet;
    march.emplace(make_pair_march(input, mesh, input.dry() ? nullptr : discretise(comm, input), on_step));
    march->start(input.march.start_motion);
  }

  CaseInput input;
  Observer observer;
  MeshModel mesh;
  MarchStatistics statistics;
  std::optional<PairMarch> march;
};

namespace {

const Case& marchable(const Case& of) {
  require_inertia(of.input());
  require_moving_train(of.input(), "a march");
  return of;
}

}  // namespace

Simulation::Simulation(MPI_Comm comm, const Case& of, Observer observer)
    : march_(std::make_unique<March>(comm, marchable(of), std::move(observer))) {}

Simulation::~Simulation() = default;

void Simulation::run_to(double mesh_periods) {
  const QuietErrors quiet;
  march_->march->run(march_->mesh.path.time_after(mesh_periods));
}

double Simulation::time() const { return march_->mesh.scales.time * march_->march->T(); }

Results Simulation::results() const {
  return Results(Results::Content{march_summary(march_->input, march_->mesh, march_->statistics)});
}

}  // namespace gearfilm
