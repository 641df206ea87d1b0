#include "traction/traction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "gearfilm/error.hpp"
#include "grid/integral.hpp"
#include "lubricant/vector_math.hpp"
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
  const auto rows = static_cast<std::size_t>(grid.y_count());
  std::vector<double> shear_rate(rows), log_newtonian(rows), half_gradient(rows), stress(rows), by_rate(rows);
  for (int i = 0; i < grid.nx(); ++i) {
    line.load(i);
    const auto sheared = [&line](std::size_t j) { return line.full_film[j] && line.velocities[j].sliding != 0.0; };
    for (std::size_t j = 0; j < rows; ++j) {
      const double h = line.thickness[j];
      shear_rate[j] = sheared(j) ? std::abs(line.velocities[j].sliding) / h : no_shear_rate;
      half_gradient[j] = 0.5 * h * line.gradient[j];
    }
    std::ranges::transform(line.log_viscosity, shear_rate, log_newtonian.begin(),
                           [](double log_viscosity, double rate) { return log_viscosity + log(rate); });
    mean_shears(model.law, {rows, log_newtonian.data(), half_gradient.data(), line.pressure.data()}, stress.data(),
                by_rate.data());
    double* signed_stress = fields.shear_stress.data() + static_cast<std::size_t>(i) * rows;
    for (std::size_t j = 0; j < rows; ++j)
      signed_stress[j] = sheared(j) ? std::copysign(stress[j], line.velocities[j].sliding) : 0.0;
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
  const std::size_t rows = velocities.size();
  for (std::size_t first = 0; first < shear_stress.size(); first += rows) {
    for (std::size_t j = 0; j < rows; ++j) shear_stress[first + j] *= velocities[j].sliding;
  }
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
  std::array<double, sums> total{};
  // The speed at which a stress acts is the same along a row.
  const auto parts_of = [&grid](const std::vector<double>& field) { return parts_of_rows(grid, field); };
  const auto put = [&](Sum sum, const std::vector<double>& parts) {
    total[sum] = std::accumulate(parts.begin(), parts.end(), 0.0);
  };
  const auto put_power = [&](Sum sum, const std::vector<double>& parts, auto speed) {
    for (std::size_t j = 0; j < parts.size(); ++j) total[sum] += parts[j] * speed(velocities[j]);
  };
  const auto sliding_speed = [](const SurfaceVelocities& u) { return u.sliding; };
  const std::vector<double> sliding_parts = parts_of(all_stress), rolling_parts = parts_of(rolling_stress(film)),
                            boundary_parts = parts_of(of_asperities);
  put(stress, sliding_parts);
  put_power(sliding_loss, sliding_parts, sliding_speed);
  put(rolling, rolling_parts);
  put_power(rolling_loss, rolling_parts, [](const SurfaceVelocities& u) { return 2.0 * u.mean; });
  put(boundary, boundary_parts);
  put_power(boundary_loss, boundary_parts, sliding_speed);
  std::vector<double> own(grid.local_size());
  film.total_pressure().store(own);
  put(pressure, parts_of(own));
  put(pinion, parts_of(fields.heat_flux_pinion));
  put(wheel, parts_of(fields.heat_flux_wheel));
  put(oil, parts_of(fields.heat_carried));
  put(generated, parts_of(fields.heat_generated));
  MPI_Allreduce(MPI_IN_PLACE, total.data(), sums, MPI_DOUBLE, MPI_SUM, grid.comm());
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

  const std::vector<double> heat = sliding_heat(velocities, std::move(all_stress));
  std::array<double, 5> maxima = {common_flash(model, grid, scales.length * grid.h_x(), velocities, heat),
                                  largest_of(fields.temperature_pinion), largest_of(fields.temperature_wheel),
                                  largest_of(fields.temperature_mean), largest_of(fields.temperature_max)};
  MPI_Allreduce(MPI_IN_PLACE, maxima.data(), static_cast<int>(maxima.size()), MPI_DOUBLE, MPI_MAX, grid.comm());
  const auto loaded = std::ranges::count_if(own, [](double value) { return value > 0.0; });
  double unconverged[] = {fields.unconverged_nodes, static_cast<double>(loaded)};
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
