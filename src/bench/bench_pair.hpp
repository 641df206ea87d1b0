// Speed of the lubricated pair: a contact-step, a whole periodic job, and what several processes make of them.
#pragma once

#include <functional>

#include "input/case.hpp"
#include "output/summary.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

struct GridSize {
  int nx, ny;
  bool operator==(const GridSize&) const = default;
};

/// Nodes of the case's grid.
GridSize size_of(const CaseInput& problem);
/// The case on another grid; a whole face keeps its rows.
CaseInput on_grid(const CaseInput& problem, GridSize size);

/// A convolution's time as the first process has it now; on a shared machine it changes. Collective.
double common_unit(MPI_Comm comm, GridSize size);

/// A film that feels its heat, in the case's own oil or one that thins as oils do.
TractionModel warm_film(const CaseInput& problem);

/// A whole command.
using Job = std::function<void(MPI_Comm, const CaseInput&)>;

/// periodic: the command of that name. Measures and prints, on 129 x 65 nodes; several processes on 257 x 257 too. A
/// whole face has its own rows.
/// Collective.
Summary bench_pair(MPI_Comm comm, const CaseInput& problem, const Job& periodic);

/// What the summary of `bench` has, for the manual.
std::string bench_markdown();

}  // namespace gearfilm
