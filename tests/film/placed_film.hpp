// The stationary film of Table 3 at a place on the line of action, and the heat of its oil.
#pragma once

#include <memory>

#include "film_case.hpp"
#include "gearfilm/traction/traction_model.hpp"

namespace gearfilm {

struct PlacedFilm {
  PlacedFilm(double xi, double force_ratio, int nx = 129, int ny = 65, Domain domain = paper_domain(2400.0))
      : pitch{table3_pitch().scales, domain},
        grid(PETSC_COMM_WORLD, pitch.shape(nx, ny)),
        load(LoadCondition::force(force_ratio * pitch.scales.static_force)) {
    const LineOfAction line(table3::gear_pair());
    const double u_m = pitch.scales.operation.entrainment_velocity;
    velocities = {.mean = line.entrainment_velocity(xi, table3::pinion_speed),
                  .sliding = line.sliding_velocity(xi, table3::pinion_speed)};
    film = std::make_unique<ContactFilm>(discretise(grid, pitch.scales), pitch.scales, MultigridOptions{});
    film->set_conditions(
        {.relative_radius = line.radius_x(xi) / pitch.scales.solids.radius_x, .entrainment = velocities.mean / u_m});
    result = solve_stationary(*film, load, SolverOptions{});
  }

  FilmCase pitch;
  Grid grid;
  LoadCondition load;
  SurfaceVelocities velocities;
  std::unique_ptr<ContactFilm> film;
  StationaryResult result;
};

inline HeatOptions heat_options(int points) { return {.oil = {.temperature_viscosity = 0.04}, .points = points}; }

inline TractionModel heated(int points = 17) {
  TractionModel model;
  model.heat = heat_options(points);
  return model;
}

}  // namespace gearfilm
