// A pair of its own in its periodic state, with a figure and a field of its own among the results: the mean in time of
// the contacts' largest pressures during the search, and the flow u h through the film at the pitch point.
#include <slepcsys.h>

#include <cstdio>
#include <exception>

#include "gearfilm/periodic_state.hpp"
#include "gearfilm/stationary_film.hpp"

using namespace gearfilm;

void compute(MPI_Comm comm) {
  Case::Values values = {{"case.name", "own_pair"},
                         {"gear.module", "3e-3"},
                         {"gear.face_width", "18e-3"},
                         {"gear.equivalent_mass", "0.4"},
                         {"pinion.speed_rpm", "4000"},
                         {"pinion.torque", "60"},
                         {"lubricant.viscosity", "0.03"},
                         {"pinion.teeth", "23"},
                         {"wheel.teeth", "31"},
                         {"gear.centre_distance", "81e-3"},
                         {"pinion.outer_radius", "37.5e-3"},
                         {"wheel.outer_radius", "49.5e-3"},
                         {"gear.pressure_angle_deg", "20"},
                         {"lubricant.pressure_viscosity", "2e-8"}};
  for (const std::string gear : {"pinion.", "wheel."}) {
    values[gear + "crowning"] = "8e-6";
    values[gear + "youngs_modulus"] = "206e9";
    values[gear + "poisson_ratio"] = "0.3";
  }
  const Case pair(comm, values);
  double sum = 0.0, time = 0.0;
  const PeriodicState state(comm, pair, [&](const Step& step) {
    for (const ContactInStep& of : step.contacts) sum += step.length * of.value("p_max") / step.contacts.size();
    time += step.length;
  });
  const StationaryFilm pitch(comm, pair);
  Results results = state.results();
  results.set("mean_pressure", sum / time);
  ResultsFolder folder(comm, pair, "own_result");
  folder.field("pitch", "flow", "m^2/s", pitch.film(),
               [&](int i, int j) { return pair.entrainment_velocity() * pitch.film().thickness(i, j); });
  folder.finish(results);
  PetscPrintf(comm, "h_min = %.6f um, mean = %.6f GPa, %s\n", 1e6 * results.number("h_min"),
              1e-9 * results.number("mean_pressure"), state.stable().value() ? "stable" : "unstable");
}

int main(int argc, char** argv) {
  if (SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0) return 1;
  int status = 0;
  try {
    compute(PETSC_COMM_WORLD);
  } catch (const std::exception& error) {
    status = std::fprintf(stderr, "%s\n", error.what()) > 0 ? 1 : 2;
  }
  return SlepcFinalize() == 0 ? status : 1;
}
