// A gear pair marched in time, watched by an observer of its own: the thinnest film, and when and where it was.
//
//   observed_march CASE.yaml [-mesh_periods 1] [-grid_nx 65] ...          also under mpiexec
// Case file and options are those of the program gearfilm.
#include <slepcsys.h>

#include <cstdio>
#include <exception>
#include <limits>
#include <vector>

#include "gearfilm/error.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "gearfilm/parallel/mpi_settings.hpp"

using namespace gearfilm;

namespace {

struct ThinnestFilm {
  double thickness = std::numeric_limits<double>::infinity();  // [m]
  double time = 0.0;                                           // [s]
  double position = 0.0;                                       // on the line of action, from the pitch point [m]
  int contact = 0;
};

// What the march tells is dimensionless, and the same on all processes.
void note(ThinnestFilm& thinnest, const StepRecord& step, const Scales& scales) {
  for (const ContactRecord& contact : step.contacts) {
    const double thickness = scales.thickness * contact.figures["h_min"];
    if (thickness < thinnest.thickness) {
      thinnest = {thickness, scales.time * step.T, contact.position, contact.number};
    }
  }
}

void watch(MPI_Comm comm, const char* case_file) {
  const Case problem = read_case(comm, case_file);
  require_inertia(problem);
  const SharedDiscretisation films = discretise(comm, problem);
  const MeshModel mesh = mesh_model(problem, problem.march.start_position);

  int steps = 0;
  ThinnestFilm thinnest;
  // The live contacts hold whole films, for who wants them. A length of zero is no step but a state from which steps
  // start: a film that enters is not yet that of its place.
  const auto observer = [&](const StepRecord& step, const std::vector<LiveContact>&) {
    if (step.dT == 0.0) return;
    ++steps;
    note(thinnest, step, problem.scales);
  };
  MeshMarch march = make_march(problem, films, mesh, observer);
  march.start(problem.march.start_motion);
  march.run(problem.march.mesh_periods * mesh.path.mesh_period());

  petsc_check(PetscPrintf(comm, "%d steps to %.4f ms\n", steps, 1e3 * problem.scales.time * march.T()));
  petsc_check(PetscPrintf(comm, "h_min = %.6f um  at %.4f ms, contact %d, xi = %+.3f mm\n", 1e6 * thinnest.thickness,
                          1e3 * thinnest.time, thinnest.contact, 1e3 * thinnest.position));
}

}  // namespace

int main(int argc, char** argv) {
  prefer_mpi_settings();
  if (SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0) return 1;
  int status = 0;
  try {
    if (argc < 2) throw InputError("observed_march CASE.yaml [-option value ...]");
    watch(PETSC_COMM_WORLD, argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    status = 1;
  }
  return SlepcFinalize() == 0 ? status : 1;
}
