#include "gearfilm/traction/film_heat.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "gearfilm/error.hpp"
#include "gearfilm/traction/across_film.hpp"
#include "gearfilm/traction/film_line.hpp"
#include "gearfilm/traction/moving_source.hpp"

namespace gearfilm {
namespace {

constexpr double least_flow = 0.1;     // of u_m h
constexpr double least_filled = 1e-3;  // of a torn film

std::array<double, 2> wall_conductances(const TractionModel& model, const SurfaceVelocities& velocities,
                                        const MovingSource& source) {
  return {1.0 / (surface_response(model.bodies[0], velocities.pinion()) * source.own_weight()),
          1.0 / (surface_response(model.bodies[1], velocities.wheel()) * source.own_weight())};
}

/// The march along x.
class FilmHeat {
public:
  FilmHeat(const TractionModel& model, const ContactFilm& film, const SurfaceVelocities& velocities)
      : grid_(film.grid()),
        model_(model),
        velocities_(velocities),
        log_ambient_(std::log(film.scales().oil.viscosity)),
        h_x_(film.scales().length * grid_.h_x()),
        source_(grid_.nx(), h_x_),
        line_(film),
        across_(model.law, film.scales().oil, *model.heat, velocities, wall_conductances(model, velocities, source_)),
        profiles_(static_cast<std::size_t>(rows()) * points(), model.heat->oil.temperature),
        flow_(rows(), HUGE_VAL),
        base_pinion_(rows()),
        base_wheel_(rows()) {
    for (int j = 0; j < rows(); ++j) {
      profile(j)[0] = model.bodies[1].temperature;
      profile(j)[points() - 1] = model.bodies[0].temperature;
    }
    for (auto* field :
         {&fields_.shear_stress, &fields_.temperature_pinion, &fields_.temperature_wheel, &fields_.temperature_mean,
          &fields_.temperature_mid, &fields_.temperature_max, &fields_.heat_flux_pinion, &fields_.heat_flux_wheel,
          &fields_.heat_generated, &fields_.heat_carried}) {
      field->assign(grid_.local_size(), 0.0);
    }
  }

  TractionFields march() {
    const double entering = model_.heat->oil.temperature;
    for (int j = 0; j < rows(); ++j) store_profile(at(0, j), j, entering);
    const int edge = grid_.local_row(grid_.rows() - 1);  // nothing happens there
    for (int i = 1; edge >= 0 && i < grid_.nx(); ++i) store_profile(at(i, edge), edge, entering);
    for (int i = 1; i < grid_.nx(); ++i) {
      line_.load(i);
      source_.earlier(fields_.heat_flux_pinion, i, base_pinion_);
      source_.earlier(fields_.heat_flux_wheel, i, base_wheel_);
      for (int first = 0; first < solved_rows(); first += AcrossFilm::lanes) solve_rows(i, first);
    }
    return std::move(fields_);
  }

private:
  int rows() const { return grid_.y_count(); }
  int solved_rows() const { return grid_.local_row(grid_.rows() - 1) >= 0 ? rows() - 1 : rows(); }
  int points() const { return model_.heat->points; }
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(i) * rows() + j; }
  double* profile(int j) { return profiles_.data() + static_cast<std::size_t>(j) * points(); }

  void solve_rows(int i, int first) {
    // Lanes beyond the last row repeat it.
    for (int l = 0; l < AcrossFilm::lanes; ++l) load_lane(l, std::min(first + l, solved_rows() - 1));
    try {
      across_.solve();
    } catch (const SolveError& error) {
      std::ostringstream message;
      message << error.what() << " near x = " << grid_.x(i) << " a, y = " << grid_.y(first)
              << " a; use more points across the film (thermal_points) or a finer grid";
      throw SolveError(message.str());
    }
    for (int l = 0; l < AcrossFilm::lanes && first + l < solved_rows(); ++l) store_lane(l, at(i, first + l), first + l);
  }

  void load_lane(int l, int j) {
    const ThermalOil& oil = model_.heat->oil;
    const double h = line_.thickness[j], p = line_.pressure[j], p_x = line_.gradient[j];
    const bool wet = line_.wet[j] != 0;
    const double inverse_viscosity = std::exp(-line_.log_viscosity[j]);
    double filled = 1.0;
    if (wet) {
      // Oil that a squeezed film throws back over the inlet takes its heat where the march does not go.
      const double poiseuille = -h * h * p_x * inverse_viscosity / 12.0, back = -velocities_.mean;
      const double part = poiseuille < back ? back / poiseuille : 1.0;
      across_.poiseuille_flow[l] = part * poiseuille;
      across_.flow[l] = std::max(least_flow * velocities_.mean, velocities_.mean + across_.poiseuille_flow[l]);
      across_.poiseuille_heat[l] = part * part * h * h * p_x * p_x * inverse_viscosity;
      flow_[j] = line_.density[j] * across_.flow[l] * h;
    } else {
      filled = std::clamp(flow_[j] / (line_.density[j] * velocities_.mean * h), least_filled, 1.0);
      across_.poiseuille_flow[l] = 0.0;
      across_.flow[l] = filled * velocities_.mean;
      across_.poiseuille_heat[l] = 0.0;
    }
    across_.wet[l] = wet ? 1.0 : 0.0;
    across_.pressure[l] = p;
    across_.thickness[l] = h;
    across_.log_viscosity[l] = line_.log_viscosity[j] - log_ambient_;
    across_.half_gradient[l] = 0.5 * h * p_x;
    across_.carried[l] = oil.density * line_.density[j] * oil.heat_capacity / h_x_;
    across_.conductivity[l] = filled * oil.conductivity_at(p);
    across_.base_pinion[l] =
        model_.bodies[0].temperature + surface_response(model_.bodies[0], velocities_.pinion()) * base_pinion_[j];
    across_.base_wheel[l] =
        model_.bodies[1].temperature + surface_response(model_.bodies[1], velocities_.wheel()) * base_wheel_[j];
    for (int k = 0; k < points(); ++k) across_.upstream[k][l] = profile(j)[k];
  }

  void store_lane(int l, std::size_t node, int j) {
    for (int k = 0; k < points(); ++k) profile(j)[k] = across_.temperatures()[k][l];
    fields_.shear_stress[node] = std::copysign(across_.stress()[l], velocities_.sliding);
    fields_.heat_flux_pinion[node] = across_.heat_pinion(l);
    fields_.heat_flux_wheel[node] = across_.heat_wheel(l);
    fields_.heat_generated[node] = across_.heat_generated(l);
    fields_.heat_carried[node] = across_.heat_carried(l);
    if (across_.missed(l)) fields_.missed += 1.0;
    store_profile(node, j, across_.mean_temperature(l));
  }

  void store_profile(std::size_t node, int j, double mean) {
    const double* T = profile(j);
    fields_.temperature_wheel[node] = T[0];
    fields_.temperature_pinion[node] = T[points() - 1];
    fields_.temperature_mean[node] = mean;
    fields_.temperature_mid[node] = T[points() / 2];
    fields_.temperature_max[node] = *std::max_element(T, T + points());
  }

  const Grid& grid_;
  const TractionModel& model_;
  SurfaceVelocities velocities_;
  double log_ambient_;
  double h_x_;  // [m]
  MovingSource source_;
  FilmLine line_;
  AcrossFilm across_;
  std::vector<double> profiles_;                  // T_k of the last line, row by row
  std::vector<double> flow_;                      // rho/rho_0 (u_m h + q_P) of the last wet node of every row
  std::vector<double> base_pinion_, base_wheel_;  // sums of moving_source.hpp
  TractionFields fields_;
};

}  // namespace

TractionFields heated_film(const TractionModel& model, const ContactFilm& film, const SurfaceVelocities& velocities) {
  return FilmHeat(model, film, velocities).march();
}

}  // namespace gearfilm
