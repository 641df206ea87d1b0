// `gearfilm static`: the dry pair turned slowly through one mesh period under several loads.
#include <iomanip>

#include "app/commands.hpp"
#include "app/corner_contact.hpp"
#include "gear/iso_stiffness.hpp"
#include "gearfilm/error.hpp"
#include "input/case_setup.hpp"
#include "mesh/static_mesh.hpp"
#include "output/file_ownership.hpp"
#include "output/output_directory.hpp"
#include "output/run_identity.hpp"
#include "output/screen.hpp"
#include "output/screen_table.hpp"
#include "results/static_summary.hpp"

namespace gearfilm {
namespace {

void write_table(MPI_Comm comm, const CaseInput& problem, const std::vector<double>& rows) {
  ResultsFile file(comm, problem.run.directory / "results.h5");
  write_identity(file, problem, "static");
  write_table(file, "/static", StaticLoad::columns(), rows);
  file.finish();
}

void print_line(MPI_Comm comm, double ratio, const Summary& at) {
  const auto um = [&](const char* name) { return 1e6 * at[name].get<double>(); };
  const std::string met =
      at["entry_penetration"].is_null() ? "-" : worded(std::fixed, std::setprecision(3), um("entry_penetration"));
  say(comm, std::fixed, std::setw(10), std::setprecision(3), ratio, std::setw(12), um("te_mean"), std::setw(14),
      um("te_peak_to_peak"), std::setw(16), std::setprecision(1), 1e-6 * at["mesh_stiffness_mean"].get<double>(),
      std::setw(16), met, std::setw(14), std::setprecision(4), at["effective_contact_ratio"].get<double>());
}

}  // namespace

void run_static(MPI_Comm comm, const CaseInput& problem) {
  if (!problem.pair.line) throw InputError(problem.parameters.file() + ": a bare contact has no mesh to be turned");
  require_tooth_force(problem, "static");
  const MeshModel mesh = mesh_after_leaving(problem);
  const OutputDirectory directory(comm, problem.run.directory);
  Summary summary = {{"case", problem.name}, {"static_force", problem.scales.operation.load}};
  Summary loads = Summary::array();
  std::vector<double> rows;
  say(comm, "load ratio  TE mean um  peak-peak um  stiffness N/um  entry meets um  contacts");
  const auto add = [&](double ratio) {
    const StaticMesh found = quasi_static_cycle(mesh, ratio * mesh.scales.static_force, problem.statics.positions);
    const StaticLoad result(mesh, found);
    Summary at = result.summary();
    result.append_rows(ratio, rows);
    print_line(comm, ratio, at);
    if (ratio == 1.0) write_whole(comm, directory.path() / shares_name, result.shares());
    return at;
  };
  Summary nominal;
  for (double ratio : problem.statics.load_ratios) {
    Summary at = add(ratio);
    if (ratio == 1.0) nominal = at;
    at["load_ratio"] = ratio;
    loads.push_back(std::move(at));
  }
  if (nominal.is_null()) nominal = add(1.0);
  summary.update(nominal);
  summary["loads"] = std::move(loads);
  const IsoStiffness iso = iso_stiffness(*problem.pair.gears, problem.pair.line->contact_ratio());
  summary["iso_stiffness_single"] = iso.single;
  summary["iso_stiffness_mesh"] = iso.mesh;
  write_table(comm, problem, rows);
  write_summary(comm, directory.path(), summary);
  ScreenTable(summary).print(comm, directory.path());
  warn_of_corner_contact(comm, mesh);
}

}  // namespace gearfilm
