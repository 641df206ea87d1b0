#include "gearfilm/io/snapshots.hpp"

#include <iomanip>
#include <sstream>

namespace gearfilm {

Snapshots::Snapshots(ResultsFile& file, const Grid& grid, const Scales& scales, std::filesystem::path xdmf)
    : file_(file), grid_(grid), scales_(scales), xdmf_(std::move(xdmf)) {
  file_.grid("/mesh", grid_, scales_);
}

void Snapshots::write(const StepRecord& record, const std::vector<LiveContact>& contacts) {
  std::ostringstream name;
  name << "/snapshots/" << std::setw(4) << std::setfill('0') << written_.size();
  const double time = scales_.time * record.T;
  file_.attribute(name.str(), "T", record.T);
  file_.attribute(name.str(), "t", time);
  TimedFields fields{time, {}};
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::string group = name.str() + "/contact" + std::to_string(contacts[k].contact);
    file_.field(group, "P", "Pa", grid_, contacts[k].film->pressure(), scales_.pressure);
    file_.field(group, "H", "m", grid_, contacts[k].film->film(), scales_.film);
    file_.attribute(group, "xi", record.contacts[k].position);
    fields.groups.push_back(group);
  }
  written_.push_back(std::move(fields));
  write_xdmf(xdmf_, "results.h5", "/mesh/mesh", grid_, written_);
}

}  // namespace gearfilm
