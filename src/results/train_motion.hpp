// What marches and periodic states say of their drive train: the table /history/train, loads of shafts and bearings,
// accelerations of the gears, the balance of energy, and spectra by orders of the pinion's shaft.
#pragma once

#include "dynamics/step_record.hpp"
#include "mesh/train_outputs.hpp"
#include "orbits/spectrum.hpp"
#include "output/results_table.hpp"
#include "output/summary.hpp"

namespace gearfilm {

class TrainHistory {
public:
  /// damping: c of a damper beside dry contacts; 0 on films. File and mesh, which has a train, must outlive it.
  TrainHistory(ResultsFile& file, const MeshModel& mesh, double damping);

  void add(const StepRecord& record);
  /// Writes what waits in memory.
  void write() { table_.write(); }

  /// Adds what the train does over [T_begin, T_end] to a summary.
  void add_to(Summary& summary, double T_begin, double T_end) const;
  /// Writes the table /orders over a span. Collective.
  void write_orders(ResultsFile& file, double T_begin, double T_end, SpectralWindow window) const;

private:
  const MeshModel& mesh_;
  double damper_;  ///< force by V_0 [-]
  TrainOutputs outputs_;
  ResultsTable table_;
  int step_ = 0;
  std::vector<TrainMoment> moments_;
};

/// Adds torques of shafts and forces on bearings at rest, of a mesh with a train.
void add_train_at_rest(const MeshModel& mesh, Summary& summary);

/// What is in the tables, in the manual's Markdown.
std::string train_motion_markdown();

}  // namespace gearfilm
