#include "traction/traction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gearfilm/error.hpp"
#include "grid/integral.hpp"
#include "parallel/agreement.hpp"
#include "traction/boundary_friction.hpp"
#include "traction/film_line.hpp"
#include "traction/moving_source.hpp"
#include "traction/sheared_flow.hpp"

namespace gearfilm {
namespace {

/// tau_m of a film that is as warm everywhere.
TractionFields isothermal_film(const TractionModel& model, const ContactFilm& film) {
  const Grid& grid = film.grid();
  TractionFields fields;
  fields.shear_stress.assign(grid.local_size(), 0.0);
  fields.boundary_stress = boundary_stress(model, film);
  FilmLine line(film);
  for (int i = 0; i < grid.nx(); ++i) {
    line.load(i);
    for (int j = 0; j < grid.y_count(); ++j) {
      const double h = line.thickness[j], sliding = line.velocities[j].sliding;
      if (!line.full_film[j] || sliding == 0.0) continue;
      const double log_newtonian = line.log_viscosity[j] + std::log(std::abs(sliding) / h);
      const double stress = mean_shear(model.law, log_newtonian, 0.5 * h * line.gradient[j], line.pressure[j]).stress;
      fields.shear_stress[static_cast<std::size_t>(i) * grid.y_count() + j] = std::copysign(stress, sliding);
    }
  }
  return fields;
}

/// h p_x/2 [Pa], compact; p is zero on the edges of the grid.
std::vector<double> rolling_stress(const ContactFilm& film) {
  const Grid& grid = film.grid();
  const Scales& scales = film.scales();
  const double scale = scales.thickness * scales.pressure / (4.0 * scales.length * grid.h_x());
  std::vector<double> stress(grid.local_size(), 0.0);
  for (int i = 1; i < grid.nx() - 1; ++i) {
    const double *west = film.film_pressure().row(i - 1), *east = film.film_pressure().row(i + 1),
                 *H = film.mean_gap().row(i);
    double* line = stress.data() + static_cast<std::size_t>(i) * grid.y_count();
    for (int j = 0; j < grid.y_count(); ++j) line[j] = scale * H[j] * (east[j] - west[j]);
  }
  return stress;
}

/// tau_m u_s, the heat of sliding [W/m^2], compact.
std::vector<double> sliding_heat(const std::vector<SurfaceVelocities>& velocities, std::vector<double> shear_stress) {
  for (std::size_t n = 0; n < shear_stress.size(); ++n) shear_stress[n] *= velocities[n % velocities.size()].sliding;
  return shear_stress;
}

/// The largest flash temperature of the own rows: both surfaces under the heat together.
double common_flash(const TractionModel& model, const Grid& grid, double h_x,
                    const std::vector<SurfaceVelocities>& velocities, const std::vector<double>& heat) {
  std::vector<double> rise(velocities.size()), response;
  for (const SurfaceVelocities& u : velocities) {
    response.push_back(1.0 / (1.0 / surface_response(model.bodies[0], u.pinion()) +
                              1.0 / surface_response(model.bodies[1], u.wheel())));
  }
  const MovingSource source(grid.nx(), h_x);
  double largest = 0.0;
  for (int i = 0; i < grid.nx(); ++i) {
    source.earlier(heat, i, rise);
    for (int j = 0; j < grid.y_count(); ++j) {
      const double own = source.own_weight() * heat[static_cast<std::size_t>(i) * grid.y_count() + j];
      largest = std::max(largest, response[j] * (rise[j] + own));
    }
  }
  return largest;
}

/// All processes fail together.
template <class Computation>
TractionFields agreed(const ContactFilm& film, Computation computation) {
  TractionFields fields;
  std::string reason;
  try {
    fields = computation();
  } catch (const SolveError& error) {
    reason = error.what();
  }
  reason = first_of_all_reasons(film.grid().comm(), reason);
  if (!reason.empty()) throw SolveError(reason);
  return fields;
}

double largest_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::ranges::max_element(values);
}

/// Quantities of fields that are known.
Traction summed(const TractionModel& model, const ContactFilm& film, TractionFields known) {
  const Grid& grid = film.grid();
  const Scales& scales = film.scales();
  Traction result;
  result.fields = std::move(known);
  const TractionFields& fields = result.fields;
  TractionQuantities& quantities = result.quantities;

  const std::vector<SurfaceVelocities> velocities = row_velocities(film);
  const std::vector<double>& of_asperities = fields.boundary_stress;
  std::vector<double> all_stress = fields.shear_stress;
  for (std::size_t n = 0; n < of_asperities.size(); ++n) all_stress[n] += of_asperities[n];
  const std::vector<double> heat = sliding_heat(velocities, all_stress);
  std::vector<double> rolling_power = rolling_stress(film);

  enum Sum {
    stress,
    rolling,
    sliding_loss,
    rolling_loss,
    pressure,
    pinion,
    wheel,
    oil,
    generated,
    boundary,
    boundary_loss,
    sums
  };
  const std::size_t size = grid.local_size();
  std::vector<double> values(sums * size, 0.0);
  const auto put = [&](Sum sum, const std::vector<double>& field) {
    std::ranges::copy(field, values.begin() + static_cast<std::ptrdiff_t>(sum * size));
  };
  put(stress, all_stress);
  put(boundary, of_asperities);
  put(boundary_loss, of_asperities.empty() ? of_asperities : sliding_heat(velocities, of_asperities));
  put(rolling, rolling_power);
  for (std::size_t n = 0; n < size; ++n) rolling_power[n] *= 2.0 * velocities[n % velocities.size()].mean;
  put(sliding_loss, heat);
  put(rolling_loss, rolling_power);
  double unconverged[] = {fields.unconverged_nodes, 0.0};
  std::vector<double> own(size);
  film.total_pressure().store(own);
  put(pressure, own);
  put(pinion, fields.heat_flux_pinion);
  put(wheel, fields.heat_flux_wheel);
  put(oil, fields.heat_carried);
  put(generated, fields.heat_generated);
  std::vector<double> total = integrals(grid, values, sums);
  // Of a line contact by unit length.
  const double area = scales.solids.line ? scales.length : scales.length * scales.length;
  for (double& integral : total) integral *= area;

  quantities.sliding_force = total[stress];
  quantities.rolling_force = total[rolling];
  const double force = scales.pressure * total[pressure];
  quantities.coefficient = force > 0.0 ? quantities.sliding_force / force : 0.0;
  quantities.power_sliding = total[sliding_loss];
  quantities.power_rolling = total[rolling_loss];
  quantities.boundary_force = total[boundary];
  quantities.boundary_coefficient = force > 0.0 ? total[boundary] / force : 0.0;
  quantities.power_boundary = total[boundary_loss];

  std::array<double, 5> maxima = {common_flash(model, grid, scales.length * grid.h_x(), velocities, heat),
                                  largest_of(fields.temperature_pinion), largest_of(fields.temperature_wheel),
                                  largest_of(fields.temperature_mean), largest_of(fields.temperature_max)};
  MPI_Allreduce(MPI_IN_PLACE, maxima.data(), static_cast<int>(maxima.size()), MPI_DOUBLE, MPI_MAX, grid.comm());
  unconverged[1] = static_cast<double>(std::ranges::count_if(own, [](double value) { return value > 0.0; }));
  MPI_Allreduce(MPI_IN_PLACE, unconverged, 2, MPI_DOUBLE, MPI_SUM, grid.comm());
  quantities.unconverged_fraction = unconverged[0] > 0.0 ? unconverged[0] / unconverged[1] : 0.0;
  quantities.flash = maxima[0];
  if (!model.heat) return result;
  quantities.surface_pinion = maxima[1];
  quantities.surface_wheel = maxima[2];
  quantities.film_mean = maxima[3];
  quantities.film_max = maxima[4];
  quantities.heat_pinion = total[pinion];
  quantities.heat_wheel = total[wheel];
  quantities.heat_oil = total[oil];
  if (total[generated] > 0.0) {
    quantities.energy_residual = (total[generated] - total[pinion] - total[wheel] - total[oil]) / total[generated];
  }
  return result;
}

}  // namespace

TractionQuantities with_powers_times(double factor, TractionQuantities quantities) {
  for (double* power : {&quantities.power_sliding, &quantities.power_rolling, &quantities.power_boundary,
                        &quantities.heat_pinion, &quantities.heat_wheel, &quantities.heat_oil}) {
    *power *= factor;
  }
  return quantities;
}

Traction traction(const TractionModel& model, const ContactFilm& film) {
  if (!model.heat) return summed(model, film, isothermal_film(model, film));
  return summed(model, film, agreed(film, [&] { return heated_film(model, film); }));
}

Traction coupled_traction(const TractionModel& model, const ContactFilm& film, FilmHeat& heat,
                          std::optional<double> time_step) {
  if (!model.heats_film()) {
    heat.flow = sheared_flow(model, film);
    return traction(model, film);
  }
  return summed(model, film, agreed(film, [&] { return sweep_heat(model, film, heat, time_step); }));
}

}  // namespace gearfilm
