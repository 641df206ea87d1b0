// The stationary film of a bare contact, and its pressure along the centre line.
//
//   bare_contact [-nx 65] [-ny 65]          also under mpiexec
// The contact is that of the case circular_m20_l10: steel spheres of 12.5 mm, Moes groups M = 20, L = 10.
#include <slepcsys.h>

#include <cstdio>
#include <exception>
#include <string>

#include "gearfilm/stationary_film.hpp"

namespace {

std::string option(const char* name, const char* otherwise) {
  char text[32] = "";
  PetscBool given = PETSC_FALSE;
  PetscOptionsGetString(nullptr, nullptr, name, text, sizeof text, &given);
  return given ? text : otherwise;
}

// The line Y = 0 inside the Hertz circle, which is the first row of all that are stored. Rows are dealt out to the
// processes: one has the whole line.
void print_centre_line(const gearfilm::Film& film, double half_axis) {
  if (film.y(0) != 0.0) return;
  for (int i = 0; i < film.nx(); ++i) {
    if (film.x(i) < -half_axis || film.x(i) > half_axis) continue;
    std::printf("x = %+.4f mm  p = %.4f GPa\n", 1e3 * film.x(i), 1e-9 * film.pressure(i, 0));
  }
}

void solve(MPI_Comm comm) {
  // The bodies, the oil, the load and the mean velocity of the surfaces in SI, and the domain in half axes.
  const gearfilm::Case contact(comm, {{"case.kind", "contact"},
                                      {"case.name", "spheres"},
                                      {"contact.radius_x", "12.5e-3"},
                                      {"contact.radius_y", "12.5e-3"},
                                      {"contact.reduced_modulus", "226e9"},
                                      {"contact.load", "5.746"},
                                      {"contact.entrainment_velocity", "0.5778"},
                                      {"lubricant.viscosity", "0.04"},
                                      {"lubricant.pressure_viscosity", "2.2e-8"},
                                      {"grid.nx", option("-nx", "65")},
                                      {"grid.ny", option("-ny", "65")},
                                      {"grid.x_min", "-4.5"},
                                      {"grid.x_max", "1.5"},
                                      {"grid.y_half", "3.0"}});
  const gearfilm::StationaryFilm solved(comm, contact);
  const gearfilm::Results& results = solved.results();
  // Results are the same on all processes, and PetscPrintf speaks once.
  PetscPrintf(comm, "h_central = %.6f um  h_min = %.6f um  p_max = %.6f GPa\n", 1e6 * results.number("h_central"),
              1e6 * results.number("h_min"), 1e-9 * results.number("p_max"));
  print_centre_line(solved.film(), contact.half_axis());
}

}  // namespace

int main(int argc, char** argv) {
  if (SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0) return 1;
  int status = 0;
  try {
    solve(PETSC_COMM_WORLD);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    status = 1;
  }
  return SlepcFinalize() == 0 ? status : 1;
}
