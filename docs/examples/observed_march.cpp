// A gear pair marched in time, watched by an observer of its own: the thinnest film, and when and where it was.
//
//   observed_march CASE.yaml [-mesh_periods 1] [-grid_nx 65] ...          also under mpiexec
// Case file and options are those of the program gearfilm.
#include <slepcsys.h>

#include <cstdio>
#include <exception>
#include <limits>
#include <string>

#include "gearfilm/error.hpp"
#include "gearfilm/simulation.hpp"

namespace {

struct ThinnestFilm {
  double thickness = std::numeric_limits<double>::infinity();  // [m]
  double time = 0.0;                                           // [s]
  double position = 0.0;                                       // on the line of action, from the pitch point [m]
  int contact = 0;
};

void watch(MPI_Comm comm, const char* case_file) {
  const gearfilm::Case pair = gearfilm::Case::read(comm, case_file);
  int steps = 0;
  ThinnestFilm thinnest;
  // What a step tells is the same on all processes. A length of zero is no step but a state from which steps start: a
  // film that enters is not yet that of its place.
  gearfilm::Simulation march(comm, pair, [&](const gearfilm::Step& step) {
    if (step.length == 0.0) return;
    ++steps;
    for (const gearfilm::ContactInStep& contact : step.contacts) {
      const double thickness = contact.value("h_min");
      if (thickness < thinnest.thickness) thinnest = {thickness, step.time, contact.position(), contact.number()};
    }
  });
  march.run_to(std::stod(pair.value("mesh_periods")));

  PetscPrintf(comm, "%d steps to %.4f ms\n", steps, 1e3 * march.time());
  PetscPrintf(comm, "h_min = %.6f um  at %.4f ms, contact %d, xi = %+.3f mm\n", 1e6 * thinnest.thickness,
              1e3 * thinnest.time, thinnest.contact, 1e3 * thinnest.position);
}

}  // namespace

int main(int argc, char** argv) {
  if (SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0) return 1;
  int status = 0;
  try {
    if (argc < 2) throw gearfilm::InputError("observed_march CASE.yaml [-option value ...]");
    watch(PETSC_COMM_WORLD, argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    status = 1;
  }
  return SlepcFinalize() == 0 ? status : 1;
}
