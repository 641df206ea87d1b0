#include "dynamics/film_process.hpp"

#include "dynamics/heat_process.hpp"

namespace gearfilm {

std::vector<std::shared_ptr<FilmProcess>> film_processes(const MeshModel& mesh) {
  std::vector<std::shared_ptr<FilmProcess>> processes;
  if (mesh.corrects_films()) processes.push_back(std::make_shared<HeatProcess>(*mesh.traction));
  return processes;
}

}  // namespace gearfilm
