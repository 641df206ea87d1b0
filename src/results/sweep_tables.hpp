// The tables of a sweep in results.h5, and what its marches settle on.
//
//   /sweep     one row a point
//   /diagram   of marches: their motion once a mesh period, at the end of each
//   /basins    of marches from a grid of starts: where each leads
#pragma once

#include "input/case.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// results: of all points, in their order. Collective.
void write_sweep_tables(MPI_Comm comm, const CaseInput& problem, const Summary& results);

/// The motions on which the marches of basins settle, with the share of the starts that lead there.
Summary attractors_of(const Summary& results);
/// One of them in a line.
std::string description_of(const Summary& attractor);
std::string basins_markdown();

}  // namespace gearfilm
