// The stationary film of Table 3 at a place on the line of action, and the heat of its oil.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "film_case.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

struct PlacedFilm {
  PlacedFilm(double xi, double force_ratio, int nx = 129, int ny = 65, Domain domain = paper_domain(2400.0),
             Edge lower = Edge::symmetry, FilmDiscretisation by = FilmDiscretisation::fitted)
      : pitch{table3_pitch().scales, domain},
        grid(PETSC_COMM_WORLD, pitch.shape(nx, ny, lower)),
        load(LoadCondition::force(force_ratio * pitch.scales.static_force)) {
    const LineOfAction line(table3::gear_pair());
    const double u_m = pitch.scales.operation.entrainment_velocity;
    velocities = {.mean = line.entrainment_velocity(xi, table3::pinion_speed),
                  .sliding = line.sliding_velocity(xi, table3::pinion_speed)};
    film = std::make_unique<ContactFilm>(discretise(grid, pitch.scales, by), pitch.scales, MultigridOptions{});
    move_surfaces(*film, {.relative_radius = line.radius_x(xi) / pitch.scales.solids.radius_x,
                          .entrainment = velocities.mean / u_m,
                          .sliding = velocities.sliding / u_m});
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

/// |G(x + e v) - G(x) - e J v| falls like e^2 at a state of a film, with the film's corrections as they are. v: changes
/// of all pressures, and of H_0.
inline void expect_second_order(const ContactFilm& corrected, const FilmSolution& state, double change_H0 = 0.0) {
  ContactFilm film(corrected.discretisation(), corrected.scales(), {.precision = Precision::double_precision});
  move_surfaces(film, corrected.conditions());
  film.set_flow_factors(corrected.flow_factors());
  const std::vector<double>& pressure = state.pressure;
  std::vector<double> change(pressure), slope(pressure.size()), at_state(pressure.size());
  for (std::size_t n = 0; n < change.size(); ++n) change[n] *= std::sin(0.7 * static_cast<double>(n));
  film.residual(pressure, state.H0, {}, at_state);
  film.linearise(pressure, state.H0, {}, 0.0);
  film.multiply(change, change_H0, slope);
  double before = 0.0;
  for (const double step : {4e-3, 2e-3, 1e-3}) {
    std::vector<double> moved(pressure), remainder(pressure.size());
    for (std::size_t n = 0; n < moved.size(); ++n) moved[n] += step * change[n];
    film.residual(moved, state.H0 + step * change_H0, {}, remainder);
    for (std::size_t n = 0; n < remainder.size(); ++n) remainder[n] -= at_state[n] + step * slope[n];
    double size = film.merit(remainder);
    MPI_Allreduce(MPI_IN_PLACE, &size, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(std::sqrt(before / size)), 2.0, 0.2);
    }
    before = size;
  }
}

}  // namespace gearfilm
