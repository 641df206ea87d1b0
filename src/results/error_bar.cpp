#include "results/error_bar.hpp"

namespace gearfilm {

void add_error_bar(Summary& summary, const std::string& name, const std::optional<Estimate>& estimate, double unit) {
  summary[name + "_error"] = estimate ? Summary(unit * estimate->error) : Summary();
  summary[name + "_extrapolated"] =
      estimate && estimate->extrapolated ? Summary(unit * *estimate->extrapolated) : Summary();
}

}  // namespace gearfilm
