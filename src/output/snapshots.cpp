#include "gearfilm/output/snapshots.hpp"

#include <iomanip>
#include <sstream>

namespace gearfilm {

Snapshots::Snapshots(ResultsFile& file, const Grid& grid, const Scales& scales, std::filesystem::path xdmf)
    : file_(file), domain_(grid), scales_(scales), xdmf_(std::move(xdmf)) {
  file_.grid("/mesh", domain_, scales_);
}

void Snapshots::write(const FilmSnapshot& snapshot) {
  std::ostringstream name;
  name << "/snapshots/" << std::setw(4) << std::setfill('0') << written_.size();
  const double time = scales_.time * snapshot.T;
  file_.attribute(name.str(), "T", snapshot.T);
  file_.attribute(name.str(), "t", time);
  TimedFields fields{time, {}};
  for (const ContactSnapshot& contact : snapshot.contacts) {
    const std::string group = name.str() + "/contact" + std::to_string(contact.number);
    fields.groups.push_back({group, {}});
    for (const auto& [field, values] : contact.fields) {
      const ContactField kind = field_named(field);
      const std::string dataset(kind.dataset);
      file_.field(group, dataset, std::string(kind.unit.name), domain_, values, kind.unit.in_si(scales_, 1.0));
      fields.groups.back().datasets.push_back(dataset);
    }
    file_.attribute(group, "xi", contact.position);
  }
  written_.push_back(std::move(fields));
  write_xdmf(xdmf_, "results.h5", "/mesh/mesh", domain_.grid(), written_);
}

}  // namespace gearfilm
