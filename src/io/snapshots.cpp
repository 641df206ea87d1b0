#include "gearfilm/io/snapshots.hpp"

#include <iomanip>
#include <sstream>

namespace gearfilm {

Snapshots::Snapshots(ResultsFile& file, const Grid& grid, const Scales& scales, std::filesystem::path xdmf)
    : file_(file), domain_(grid), scales_(scales), xdmf_(std::move(xdmf)) {
  file_.grid("/mesh", domain_, scales_);
}

void Snapshots::write(const StepRecord& record, const std::vector<LiveContact>& contacts) {
  std::vector<ContactFields> fields;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    fields.push_back(
        {contacts[k].contact, record.contacts[k].position, &contacts[k].film->pressure(), &contacts[k].film->film()});
  }
  write(record.T, fields);
}

void Snapshots::hold(const StepRecord& record, const std::vector<LiveContact>& contacts) {
  Held held{record.T, {}};
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    held.contacts.push_back(
        {contacts[k].contact, record.contacts[k].position, contacts[k].film->pressure(), contacts[k].film->film()});
  }
  held_.push_back(std::move(held));
}

void Snapshots::write_held(double T_after) {
  for (const Held& held : held_) {
    if (held.T <= T_after) continue;
    std::vector<ContactFields> fields;
    for (const HeldContact& contact : held.contacts) {
      fields.push_back({contact.contact, contact.position, &contact.pressure, &contact.film});
    }
    write(held.T, fields);
  }
  held_.clear();
}

void Snapshots::write(double T, const std::vector<ContactFields>& contacts) {
  std::ostringstream name;
  name << "/snapshots/" << std::setw(4) << std::setfill('0') << written_.size();
  const double time = scales_.time * T;
  file_.attribute(name.str(), "T", T);
  file_.attribute(name.str(), "t", time);
  TimedFields fields{time, {}};
  for (const ContactFields& contact : contacts) {
    const std::string group = name.str() + "/contact" + std::to_string(contact.contact);
    file_.field(group, "P", "Pa", domain_, *contact.pressure, scales_.pressure);
    file_.field(group, "H", "m", domain_, *contact.film, scales_.film);
    file_.attribute(group, "xi", contact.position);
    fields.groups.push_back(group);
  }
  written_.push_back(std::move(fields));
  write_xdmf(xdmf_, "results.h5", "/mesh/mesh", domain_.grid(), written_);
}

}  // namespace gearfilm
