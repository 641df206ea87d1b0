#include "app/corner_contact.hpp"

#include "mesh/static_mesh.hpp"
#include "output/screen.hpp"

namespace gearfilm {

void warn_of_corner_contact(MPI_Comm comm, const MeshModel& mesh) {
  const std::optional<double> met = entry_penetration(mesh, mesh.scales.static_force);
  if (met.value_or(0.0) <= 0.0) return;
  warn(comm, std::setprecision(3), "an entering tooth meets its mate with a penetration of ",
       1e6 * *met * mesh.scales.thickness, " um: real tips would touch ", 1e3 * corner_distance(mesh, *met),
       " mm before the path of contact begins, which is not modelled; tip relief of the wheel reduces it");
}

}  // namespace gearfilm
