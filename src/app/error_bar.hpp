// The error bar of a figure in a summary: `_error`, and `_extrapolated`, where finer grids lead to.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "app/warning.hpp"
#include "gearfilm/input/case.hpp"
#include "gearfilm/numerics/estimate.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Both null where nothing is known of it, the latter also where no limit is in sight. `unit`: of the estimate, in SI.
inline void add_error_bar(Summary& summary, const std::string& name, const std::optional<Estimate>& estimate,
                          double unit = 1.0) {
  summary[name + "_error"] = estimate ? Summary(unit * estimate->error) : Summary();
  summary[name + "_extrapolated"] =
      estimate && estimate->extrapolated ? Summary(unit * *estimate->extrapolated) : Summary();
}

/// Relative error up to which nothing is said of it: 5 %, or more where the case itself says so by grid.accuracy.
inline double tolerable_error(const Case& problem) {
  constexpr double usual = 0.05;
  const std::string accuracy = "grid.accuracy";
  return problem.parameters.given(accuracy) ? std::max(usual, problem.parameters.real(accuracy)) : usual;
}

/// Says that the bar of the largest pressure is that of a spike, where it is.
inline void note_spike(MPI_Comm comm, const Summary& summary) {
  if (!summary.contains("p_max_error") || summary["p_max_error"].is_null()) return;
  if (!summary["p_max_extrapolated"].is_null()) return;
  say(comm,
      "the largest pressure is, or may become on finer grids, that of the outlet's spike, whose limit is not known: "
      "its error is what doubling the nodes twice may add");
}

}  // namespace gearfilm
