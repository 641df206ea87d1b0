// The error bar of a quantity in a summary: `_error`, and `_extrapolated`, where finer grids lead to.
#pragma once

#include <optional>
#include <string>

#include "numerics/estimate.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Both null where nothing is known of it, the latter also where no limit is in sight. `unit`: of the estimate, in SI.
void add_error_bar(Summary& summary, const std::string& name, const std::optional<Estimate>& estimate,
                   double unit = 1.0);

}  // namespace gearfilm
