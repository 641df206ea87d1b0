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
    const std::string group = name.str() + "/contact" + std::to_string(contact.contact);
    file_.field(group, "P", "Pa", domain_, contact.pressure, scales_.pressure);
    file_.field(group, "H", "m", domain_, contact.film, scales_.film);
    file_.attribute(group, "xi", contact.position);
    fields.groups.push_back(group);
  }
  written_.push_back(std::move(fields));
  write_xdmf(xdmf_, "results.h5", "/mesh/mesh", domain_.grid(), written_);
}

}  // namespace gearfilm
