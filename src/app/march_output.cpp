#include "app/march_output.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "gearfilm/error.hpp"
#include "output/run_identity.hpp"
#include "results/contact_map_result.hpp"
#include "results/poincare_result.hpp"
#include "results/spectrum_result.hpp"

namespace gearfilm {

namespace {

constexpr double search_snapshot_interval = 0.05;  // mesh periods

double snapshot_interval(const CaseInput& problem, MarchPurpose purpose) {
  return problem.march.snapshot_interval.value_or(purpose == MarchPurpose::search ? search_snapshot_interval : 0.0);
}

/// Marches have no damper beside dry contacts unless one is given, searches that of a film.
double dry_damping_ratio(const CaseInput& problem, MarchPurpose purpose) {
  return problem.march.dry_damping_ratio.value_or(purpose == MarchPurpose::search ? typical_film_damping : 0.0);
}

}  // namespace

MarchOutput::MarchOutput(ResumableRun& run, const CaseInput& problem, const Grid& grid, const MeshModel& mesh,
                         MarchPurpose purpose, double expected_periods)
    : checkpoint_(run.checkpoint()),
      problem_(problem),
      mesh_(mesh),
      purpose_(purpose),
      lubricated_(!problem.dry()),
      expected_periods_(expected_periods),
      file_(grid.comm(), run.directory() / "results.h5"),
      history_(std::in_place, file_, mesh, lubricated_),
      statistics_(mesh.path.mesh_period(), mesh.scales.static_force, mesh.path.course()),
      ratings_(mesh),
      progress_(grid.comm()) {
  if (lubricated_) {
    const auto period = purpose == MarchPurpose::search ? std::optional(mesh.period()) : std::nullopt;
    maps_ = std::make_unique<CarriedMaps>(mesh, problem.parameters.integer("fatigue.flank_points"), period);
    checkpoint_.carry(*maps_);
  }
  write_identity(file_, problem, purpose == MarchPurpose::march ? "transient" : "periodic");
  if (mesh.train)
    train_.emplace(file_, mesh, lubricated_ ? 0.0 : dry_damping(mesh, dry_damping_ratio(problem, purpose)));
  if (lubricated_ && snapshot_interval(problem, purpose) > 0.0) {
    snapshots_.emplace(file_, problem.scales, run.directory() / "results.xmf");
  }
}

void MarchOutput::step(const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  history_->append(record);
  if (train_) train_->add(record);
  statistics_.add(record, available_models(mesh_, lubricated_));
  signal_.add(record);
  section_.add(record);
  ratings_.add(record);
  if (maps_) maps_->maps.add(record, contacts);
  last_time_ = record.T;
  const double period = mesh_.path.mesh_periods(record.T);
  if (snapshots_ && period >= next_snapshot_ - 1e-9) {
    take_snapshot(record, contacts);
    const double interval = snapshot_interval(problem_, purpose_);
    next_snapshot_ = interval * (std::floor(period / interval + 1e-9) + 1.0);
  }
  if (checkpoint_.is_new(record)) publish();
  if (!record.replayed) report(record, period);
}

void MarchOutput::take_snapshot(const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  const std::optional<FilmSnapshot> snapshot =
      record.replayed ? checkpoint_.recall_snapshot() : film_snapshot(mesh_, record, contacts);
  if (!snapshot) return;
  if (!record.replayed) checkpoint_.attach(*snapshot);
  if (purpose_ == MarchPurpose::search) {
    held_.push_back(*snapshot);
  } else {
    snapshots_->write(*snapshot);
  }
}

std::string text_of(const SearchPeriod& period) {
  return worded("mesh period ", period.number, " repeats within ", std::scientific, std::setprecision(1), period.defect,
                " in (H0, V0), ", period.film_defect, " in the films",
                period.halved_steps > 0 ? worded(" (", period.halved_steps, " time steps had to be halved)") : "");
}

void MarchOutput::end_search_period(const SearchPeriod& period) {
  note(text_of(period));
  if (maps_ && period.accepted) found_maps_ = maps_->maps.maps();
  if (!snapshots_) return;
  for (const FilmSnapshot& snapshot : held_) {
    if (period.accepted && snapshot.T > period.begin) snapshots_->write(snapshot);
  }
  if (!period.accepted) checkpoint_.drop_snapshots();
  held_.clear();
}

// Whole up to here: whatever ends the program next, there are no fewer rows than before it began.
void MarchOutput::publish() {
  if (file_.published()) return;
  write_history();
  file_.publish();
}

void MarchOutput::write_flanks(const std::optional<FlankResults>& fatigue) {
  const std::optional<ContactMapPair> maps = purpose_ == MarchPurpose::search ? found_maps_
                                             : maps_                          ? maps_->maps.maps()
                                                                              : std::nullopt;
  if (maps) write_contact_maps(file_, *maps);
  if (maps && fatigue) gearfilm::write_flanks(file_, *mesh_.fatigue, *fatigue);
}

void MarchOutput::finish() {
  write_history();
  history_.reset();
  train_.reset();
  file_.finish();
}

void MarchOutput::write_history() {
  history_->write();
  if (train_) train_->write();
}

Summary MarchOutput::write_spectrum(double T_begin, double T_end, SpectralWindow window) {
  if (train_) train_->write_orders(file_, T_begin, T_end, window);
  return gearfilm::write_spectrum(file_, problem_.scales, signal_.spectrum(T_begin, T_end, window), window);
}

// Bodies in balance move no train: its loads are those at rest.
void MarchOutput::add_train_motion(double T_begin, double T_end, Summary& summary) const {
  if (train_) {
    train_->add_to(summary, T_begin, T_end);
  } else if (problem_.pair.train) {
    MeshModel at_rest = mesh_;
    at_rest.train = mesh_train_of(problem_);
    add_train_at_rest(at_rest, summary);
  }
}

void MarchOutput::describe_recurrence(Summary& summary) {
  write_poincare(file_, mesh_, lubricated_, section_.points());
  if (mesh_.path.course().duration == 0.0) add_recurrence(section_.points(), summary);
}

void MarchOutput::report(const StepRecord& record, double period) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "mesh period " << period << ", total force ratio "
       << record.pressure_integral() / problem_.scales.static_force;
  if (!record.contacts.empty()) text << ", xi = " << 1e3 * record.contacts.front().position << " mm";
  if (lubricated_ && !record.contacts.empty()) {
    double smallest = record.contacts.front().quantities["h_min"];
    for (const ContactRecord& contact : record.contacts) smallest = std::min(smallest, contact.quantities["h_min"]);
    text << ", smallest film " << 1e6 * problem_.scales.thickness * smallest << " um";
  }
  progress_.report(std::min(1.0, period / expected_periods_), text.str());
}

}  // namespace gearfilm
