// The result of `steady`: the stationary film of one contact at one position on the line of action, its friction and
// heat, its error bars, and what formulas say of it.
#pragma once

#include "input/case.hpp"
#include "mesh/meshed_contact.hpp"
#include "output/summary.hpp"
#include "traction/accurate_film.hpp"

namespace gearfilm {

/// The contact at the chosen position: conditions for the solver, and in SI for the film formulas.
struct SteadyPosition {
  MeshedContact contact;
  Compliance compliance;  ///< of its teeth
  ContactSolids solids;
  ContactOperation operation;
  std::string label = "bare contact";
};

SteadyPosition steady_position(const CaseInput& problem);

/// The case's grid, wider where the contact needs that. Collective.
GridShape steady_grid(MPI_Comm comm, const CaseInput& problem, const SteadyPosition& position,
                      const WideningObserver& on_widening);
/// The program has chosen the nodes.
bool chooses_nodes(const CaseInput& problem);

struct SteadyResult {
  SteadyPosition position;
  SolvedContact solved;
  Traction friction;   ///< with the losses of the whole tooth
  int stress_row = 0;  ///< below which stresses are computed: that of the largest load
  Summary summary;     ///< in SI
};

/// As accurate as asked for where the program chose the grid. Throws SolveError. Collective.
SteadyResult solve_steady(const Grid& grid, const CaseInput& problem, const SteadyPosition& position,
                          const Watcher& watcher);

/// results.h5, results.xmf and summary.json in the case's folder. Collective.
void write_results(MPI_Comm comm, const CaseInput& problem, const SteadyResult& result);

/// What is in its summary, in the manual's Markdown.
std::string steady_markdown();

}  // namespace gearfilm
