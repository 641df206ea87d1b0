// The stationary film of a bare contact, and its pressure along the centre line.
//
//   bare_contact [-nx 65] [-ny 65]          also under mpiexec
// The contact is that of the case circular_m20_l10: steel spheres of 12.5 mm, Moes groups M = 20, L = 10.
#include <slepcsys.h>

#include <cstdio>
#include <exception>

#include "gearfilm/solver/stationary.hpp"
#include "gearfilm/film/validity.hpp"
#include "gearfilm/parallel/mpi_settings.hpp"

using namespace gearfilm;

namespace {

int option(const char* name, int otherwise) {
  PetscInt value = otherwise;
  petsc_check(PetscOptionsGetInt(nullptr, nullptr, name, &value, nullptr));
  return static_cast<int>(value);
}

// The line Y = 0 inside the Hertz circle. It is the first row of the grid, which is cut across its
// rows: one process has the whole line.
void print_centre_line(const Grid& grid, const Scales& scales, const Field<double>& pressure) {
  const int row = grid.local_row(grid.row_axis().central());
  if (row < 0) return;
  for (int i = 0; i < grid.nx(); ++i) {
    if (grid.x(i) < -1.0 || grid.x(i) > 1.0) continue;
    std::printf("x = %+.4f mm  p = %.4f GPa\n", 1e3 * scales.length * grid.x(i),
                1e-9 * scales.pressure * pressure.row(i)[row]);
  }
}

void solve(MPI_Comm comm) {
  // SI: the bodies, the oil, the load and the mean velocity of the surfaces.
  const ContactSolids solids{.radius_x = 12.5e-3, .radius_y = 12.5e-3, .reduced_modulus = 226e9};
  const Lubricant oil{.viscosity = 0.04, .pressure_viscosity = 2.2e-8};
  const ContactOperation operation{.load = 5.746, .entrainment_velocity = 0.5778};
  const Scales scales = make_scales(solids, oil, operation);

  const Domain domain = paper_domain(moes_groups(solids, oil, operation).M);
  const Grid grid(comm, grid_shape(domain, scales.hertz.ellipticity, option("-nx", 65), option("-ny", 65)));
  const SolverOptions options;
  ContactFilm film(discretise(grid, scales), scales, options.multigrid);
  const StationaryResult result = solve_stationary(film, LoadCondition::force(scales.static_force), options);
  check_validity(film, result.figures, "bare contact");

  // Figures are the same on all processes, and PetscPrintf speaks once.
  petsc_check(PetscPrintf(comm, "h_central = %.6f um  h_min = %.6f um  p_max = %.6f GPa\n",
                          1e6 * scales.thickness * result.figures.central_film,
                          1e6 * scales.thickness * result.figures.smallest_film,
                          1e-9 * scales.pressure * result.figures.largest_pressure));
  print_centre_line(grid, scales, film.total_pressure());
}

}  // namespace

int main(int argc, char** argv) {
  prefer_mpi_settings();
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
