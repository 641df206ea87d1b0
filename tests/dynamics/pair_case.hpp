// What the dynamics tests share: the pairs of input/, and marches that keep what they pass through.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "film_case.hpp"
#include "gearfilm/dynamics/dry_pair.hpp"
#include "gearfilm/dynamics/march_statistics.hpp"
#include "gearfilm/dynamics/mesh_march.hpp"
#include "gearfilm/input/case.hpp"
#include "gearfilm/input/case_file.hpp"

namespace gearfilm {

/// Values of a case by their keys.
using Settings = std::map<std::string, std::string>;

/// A case of input/ with some of its values replaced.
inline Case input_case(const std::string& file, const Settings& settings = {}) {
  ParameterValues values = read_parameters(PETSC_COMM_WORLD, std::string(GEARFILM_SOURCE_DIR) + "/input/" + file);
  for (const auto& [key, value] : settings) values.set(key, value, "test");
  return make_case(values);
}

inline Case table3_case(const Settings& settings = {}) { return input_case("barbieri2013.yaml", settings); }

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

/// The given settings take precedence.
inline Settings with(Settings settings, const Settings& replaced) {
  for (const auto& [key, value] : replaced) settings[key] = value;
  return settings;
}

inline ContactPath path_of(const Case& problem) {
  return {*problem.line, problem.scales, problem.pinion_speed, problem.start_position};
}

inline double inertia_of(const Case& problem) { return problem.scales.inertia(*problem.equivalent_mass); }

inline GridShape shape_of(const Case& problem) {
  return grid_shape(problem.domain, problem.scales.hertz.ellipticity, problem.nx, problem.ny);
}

/// A lubricated march of a case that keeps its records.
class RecordedMarch {
public:
  explicit RecordedMarch(Case problem, MPI_Comm comm = PETSC_COMM_WORLD)
      : problem_(std::move(problem)),
        discretisation_(discretise(Grid(comm, shape_of(problem_)), problem_.scales)),
        path_(path_of(problem_)),
        march_(discretisation_, problem_.scales, path_, inertia_of(problem_), film_options(), problem_.steps,
               [this](const StepRecord& record, const std::vector<LiveContact>& contacts) {
                 records_.push_back(record);
                 if (on_step) on_step(record, contacts);
               }) {}
  RecordedMarch(const RecordedMarch&) = delete;
  RecordedMarch& operator=(const RecordedMarch&) = delete;

  MeshMarch& march() { return march_; }
  void start() { march_.start(problem_.start_motion); }
  void run(double T_end) { march_.run(T_end); }

  const Case& problem() const { return problem_; }
  const SharedDiscretisation& discretisation() const { return discretisation_; }
  const Grid& grid() const { return discretisation_->grid(); }
  const ContactPath& path() const { return path_; }
  const Motion& motion() const { return march_.motion(); }
  const std::vector<StepRecord>& records() const { return records_; }
  /// Unit of forces.
  double static_force() const { return problem_.scales.static_force; }

  StepObserver on_step;  ///< called after the record is kept

private:
  SolverOptions film_options() const {
    SolverOptions options = problem_.solver;
    options.multigrid.levels = step_levels(grid(), problem_.steps.dT);
    return options;
  }

  Case problem_;
  SharedDiscretisation discretisation_;
  ContactPath path_;
  std::vector<StepRecord> records_;
  MeshMarch march_;
};

/// What the march has passed through, in figures.
inline MarchStatistics statistics_of(const RecordedMarch& march) {
  MarchStatistics statistics(march.path().mesh_period(), march.static_force());
  for (const StepRecord& record : march.records()) statistics.add(record, true);
  return statistics;
}

}  // namespace gearfilm
