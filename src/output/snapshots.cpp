#include "output/snapshots.hpp"

#include <iomanip>
#include <utility>

#include "gearfilm/error.hpp"

namespace gearfilm {

std::vector<std::string> write_fields(ResultsFile& file, const std::string& group, const WholeDomain& domain,
                                      const Scales& scales, const std::vector<NamedField>& fields,
                                      const std::string& axes) {
  std::vector<std::string> datasets;
  for (const auto& [name, values] : fields) {
    const ContactField kind = field_named(name);
    datasets.emplace_back(kind.dataset);
    file.field(group, datasets.back(), std::string(kind.unit.name), domain, values, kind.unit.in_si(scales, 1.0), axes);
  }
  return datasets;
}

Snapshots::Snapshots(ResultsFile& file, Scales scales, std::filesystem::path xdmf)
    : file_(file), scales_(std::move(scales)), xdmf_(std::move(xdmf)) {}

const Snapshots::Mesh& Snapshots::mesh_of(const GridShape& shape) {
  for (const auto& known : meshes_) {
    if (known->grid.shape() == shape) return *known;
  }
  const std::string group = meshes_.empty() ? "/mesh" : "/mesh" + std::to_string(meshes_.size());
  meshes_.push_back(std::make_unique<Mesh>(Grid(file_.comm(), shape), group));
  file_.grid(group, meshes_.back()->domain, scales_);
  return *meshes_.back();
}

void Snapshots::write(const FilmSnapshot& snapshot) {
  const std::string name = worded("/snapshots/", std::setw(4), std::setfill('0'), written_.size());
  const double time = scales_.time * snapshot.T;
  const Mesh& mesh = mesh_of(snapshot.shape);
  file_.attribute(name, "T", snapshot.T);
  file_.attribute(name, "t", time);
  file_.attribute(name, "mesh", mesh.group);
  TimedFields fields{time, {}};
  for (const ContactSnapshot& contact : snapshot.contacts) {
    const std::string group = name + "/contact" + std::to_string(contact.number);
    fields.groups.push_back({contact.number, group, mesh.group + "/mesh", mesh.grid.shape(), {}});
    fields.groups.back().datasets = write_fields(file_, group, mesh.domain, scales_, contact.fields, mesh.group);
    file_.attribute(group, "xi", contact.position);
  }
  written_.push_back(std::move(fields));
  write_xdmf(file_.comm(), xdmf_, "results.h5", written_);
}

}  // namespace gearfilm
