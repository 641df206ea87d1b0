// The conditions under which a pair runs: members of each point of a sweep and of a continuation.
#pragma once

#include "input/case.hpp"
#include "output/results_table.hpp"
#include "output/summary.hpp"

namespace gearfilm {

struct PairConditions {
  const CaseInput& here;  ///< the case with what is varied
  const MeshModel& mesh;
};

/// Speed, torque, mass, viscosity and frequencies; of a pair that has inertia.
void add_conditions(const PairConditions& at, Summary& result);
std::vector<TableColumn> condition_columns();
void add_conditions_to_row(const PairConditions& at, std::vector<double>& row);
std::string conditions_markdown();

}  // namespace gearfilm
