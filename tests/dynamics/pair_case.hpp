// What the dynamics tests share: the pairs of input/, and marches that keep what they pass through.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/dry_pair.hpp"
#include "dynamics/march_statistics.hpp"
#include "dynamics/mesh_march.hpp"
#include "film_case.hpp"
#include "input/case.hpp"
#include "input/case_file.hpp"
#include "input/case_setup.hpp"

namespace gearfilm {

/// Values of a case by their keys.
using Settings = std::map<std::string, std::string>;

/// The given settings take precedence.
inline Settings with(Settings settings, const Settings& replaced) {
  for (const auto& [key, value] : replaced) settings[key] = value;
  return settings;
}

/// A case of input/ with some of its values replaced.
inline CaseInput input_case(const std::string& file, const Settings& settings = {}) {
  ParameterValues values = read_parameters(PETSC_COMM_WORLD, std::string(GEARFILM_SOURCE_DIR) + "/input/" + file);
  for (const auto& [key, value] : settings) values.set(key, value, "test");
  return make_case(values);
}

inline CaseInput table3_case(const Settings& settings = {}) { return input_case("barbieri2013.yaml", settings); }

/// Teeth and bodies that give way, with bores that are not in the paper.
inline Settings bending(const std::string& body = "yes") {
  return {{"gear.tooth_compliance", "weber"},
          {"gear.body_coupling", body},
          {"pinion.bore_radius", "0.02"},
          {"wheel.bore_radius", "0.02"}};
}

/// Of both tips, so long and deep that contacts enter unloaded under the static force.
inline Settings relieved() {
  return {{"pinion.tip_relief", "65e-6"},
          {"pinion.tip_relief_length", "2.9e-3"},
          {"wheel.tip_relief", "65e-6"},
          {"wheel.tip_relief_length", "2.9e-3"}};
}

/// Table 3 on 65 x 33 nodes, just after a contact has left, with the motion of the periodic state there.
inline Settings after_leaving() {
  const auto& state = table3::reference().at("film_periodic_129x65_dT_0.026");
  return {{"grid.nx", "65"},
          {"grid.ny", "33"},
          {"time.dt", "0.05"},
          {"start.place", "after_leaving"},
          {"start.H0", state.at("H0_after_leaving").at("value").dump()},
          {"start.V0", state.at("V0_after_leaving").at("value").dump()}};
}

/// The elder contact sits 0.2 before the place where the next one enters (in T).
inline Settings before_an_entry() {
  return with(after_leaving(),
              {{"start.place", "position"}, {"start.position", "3.0e-3"}, {"start.H0", "-1.3"}, {"start.V0", "-0.3"}});
}

/// The mesh of a case at its start.
inline MeshModel mesh_of(const CaseInput& problem) { return mesh_model(problem, problem.march.start_position); }

/// A lubricated march of a case that keeps its records.
class RecordedMarch {
public:
  explicit RecordedMarch(CaseInput problem, MPI_Comm comm = PETSC_COMM_WORLD)
      : problem_(std::move(problem)),
        discretisation_(discretise(comm, problem_)),
        march_(make_march(problem_, discretisation_, mesh_of(problem_),
                          [this](const StepRecord& record, const std::vector<ActiveContact>& contacts) {
                            records_.push_back(record);
                            if (on_step) on_step(record, contacts);
                          })) {}
  RecordedMarch(const RecordedMarch&) = delete;
  RecordedMarch& operator=(const RecordedMarch&) = delete;

  MeshMarch& march() { return march_; }
  void start() { march_.start(problem_.march.start_motion); }
  void run(double T_end) { march_.run(T_end); }

  const CaseInput& problem() const { return problem_; }
  const SharedDiscretisation& discretisation() const { return discretisation_; }
  const Grid& grid() const { return discretisation_->grid(); }
  const MeshModel& mesh() const { return march_.mesh(); }
  const ContactPath& path() const { return mesh().path; }
  const Motion& motion() const { return march_.motion(); }
  const std::vector<StepRecord>& records() const { return records_; }
  /// Unit of forces.
  double static_force() const { return problem_.scales.static_force; }

  StepObserver on_step;  ///< called after the record is kept

private:
  CaseInput problem_;
  SharedDiscretisation discretisation_;
  std::vector<StepRecord> records_;
  MeshMarch march_;
};

/// Keeps what a march gives it, and gives it back as a program that was started again would find it.
class Memory final : public RunStore {
public:
  std::optional<StoredRun> begin_run(double, const Motion&) override { return known; }
  void record(const StepRecord&) override {}
  void keep(double T, const PairState& state, std::vector<double> memory) override {
    kept.push_back({{}, T, state, std::move(memory)});
  }

  std::vector<StoredRun> kept;
  std::optional<StoredRun> known;
};

/// What the march has passed through, in quantities.
inline MarchStatistics statistics_of(const RecordedMarch& march) {
  MarchStatistics statistics(march.path().mesh_period(), march.static_force());
  for (const StepRecord& record : march.records()) statistics.add(record, {});
  return statistics;
}

/// Of fields that are cut among all processes.
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) largest = std::max(largest, std::abs(a[n] - b[n]));
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  return largest;
}

}  // namespace gearfilm
