#include "gearfilm/traction/film_heat.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "gearfilm/error.hpp"
#include "gearfilm/traction/across_film.hpp"
#include "gearfilm/traction/film_line.hpp"
#include "gearfilm/traction/moving_source.hpp"
#include "gearfilm/traction/sheared_flow.hpp"

namespace gearfilm {
namespace {

constexpr double least_flow = 0.1;     // of u_m h
constexpr double least_filled = 1e-3;  // of a torn film

/// The march along x.
class HeatMarch {
public:
  HeatMarch(const TractionModel& model, const ContactFilm& film, const SurfaceVelocities& velocities, FilmFlow flow,
            FilmHeat& heat, std::optional<double> time_step = {})
      : grid_(film.grid()),
        film_(film),
        model_(model),
        velocities_(velocities),
        log_ambient_(std::log(film.scales().oil.viscosity)),
        inverse_span_(inverse_roelands_span(film.scales().oil)),
        h_x_(film.scales().length * grid_.h_x()),
        own_(flow == FilmFlow::own),
        response_{surface_response(model.bodies[0], velocities.pinion()),
                  surface_response(model.bodies[1], velocities.wheel())},
        source_(grid_.nx(), h_x_),
        line_(film),
        across_(model.law, film.scales().oil, *model.heat, velocities,
                {1.0 / (response_[0] * source_.own_weight()), 1.0 / (response_[1] * source_.own_weight())}, flow),
        heat_(heat),
        flow_(rows(), HUGE_VAL),
        base_pinion_(rows()),
        base_wheel_(rows()),
        gain_(static_cast<std::size_t>(rows()) * points()) {
    const std::size_t nodes = grid_.local_size();
    if (time_step) {
      storage_ = model.heat->oil.density * model.heat->oil.heat_capacity / *time_step;
      earlier_ = heat.temperatures;
    }
    if (heat.temperatures.empty()) heat.temperatures.assign(nodes * points(), model.heat->oil.temperature);
    for (int j = 0; j < rows(); ++j) {
      std::fill_n(profile(0, j), points(), model.heat->oil.temperature);
      profile(0, j)[0] = model.bodies[1].temperature;
      profile(0, j)[points() - 1] = model.bodies[0].temperature;
    }
    for (auto* field :
         {&fields_.shear_stress, &fields_.temperature_pinion, &fields_.temperature_wheel, &fields_.temperature_mean,
          &fields_.temperature_mid, &fields_.temperature_max, &fields_.heat_flux_pinion, &fields_.heat_flux_wheel,
          &fields_.heat_generated, &fields_.heat_carried}) {
      field->assign(nodes, 0.0);
    }
    if (!own_) return;
    heat.flow = FlowCorrection::none(nodes);
    heat.flow.sheared = model.shear_in_film;
    fields_.log_flow_factor.assign(nodes, 0.0);
    if (heat.passing.empty()) heat.passing.assign(nodes * points(), 0.0);
  }

  TractionFields march() {
    const int edge = grid_.local_row(grid_.rows() - 1);  // nothing happens there
    line_.load(0);
    for (int j = 0; j < rows(); ++j) {
      store_entering(0, j);
      for (int k = 0; own_ && k < points(); ++k) {
        const double place = static_cast<double>(k) / (points() - 1);
        passing(0, j)[k] = line_.density[j] * line_.thickness[j] * (velocities_.wheel() + place * velocities_.sliding);
      }
    }
    for (int i = 1; i < grid_.nx(); ++i) {
      if (edge >= 0) {
        std::copy_n(profile(0, edge), points(), profile(i, edge));
        store_entering(i, edge);
      }
      solve_line(i);
    }
    // Back again, so that what oil brings from downstream reaches the inlet in one sweep; in a time step it comes as
    // far as a step takes it.
    returning_ = true;
    for (int i = storage_ > 0.0 ? 0 : last_returning_; i > 0; --i) solve_line(i);
    if (grid_.local_row(0) == 0) {
      for (int i = 0; i < grid_.nx(); ++i) {
        fields_.across.insert(fields_.across.end(), profile(i, 0), profile(i, 0) + points());
      }
    }
    return std::move(fields_);
  }

private:
  int rows() const { return grid_.y_count(); }
  int solved_rows() const { return grid_.local_row(grid_.rows() - 1) >= 0 ? rows() - 1 : rows(); }
  int points() const { return model_.heat->points; }
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(i) * rows() + j; }
  double* profile(int i, int j) { return heat_.temperatures.data() + at(i, j) * points(); }
  /// What a sweep changed on the line that was solved last.
  double* gain(int j) { return gain_.data() + static_cast<std::size_t>(j) * points(); }
  /// rho/rho_0 h u_k [m^2/s].
  double* passing(int i, int j) { return heat_.passing.data() + at(i, j) * points(); }

  void solve_line(int i) {
    line_.load(i);
    source_.earlier(fields_.heat_flux_pinion, i, base_pinion_);
    source_.earlier(fields_.heat_flux_wheel, i, base_wheel_);
    for (int first = 0; first < solved_rows(); first += AcrossFilm::lanes) solve_rows(i, first);
  }

  void solve_rows(int i, int first) {
    // Lanes beyond the last row repeat it.
    for (int l = 0; l < AcrossFilm::lanes; ++l) {
      const int j = std::min(first + l, solved_rows() - 1);
      load_lane(l, j);
      if (own_) {
        load_own_flow(l, i, j);
      } else {
        load_isothermal_flow(l, i, j);
      }
      load_profiles(l, i, j);
    }
    try {
      across_.solve();
    } catch (const SolveError& error) {
      std::ostringstream message;
      message << error.what() << " near x = " << grid_.x(i) << " a, y = " << grid_.y(first)
              << " a; use more points across the film (thermal_points) or a finer grid";
      throw SolveError(message.str());
    }
    for (int l = 0; l < AcrossFilm::lanes && first + l < solved_rows(); ++l) {
      if (!returning_ || line_.wet[first + l]) store_lane(l, i, first + l);
    }
  }

  void load_lane(int l, int j) {
    const double h = line_.thickness[j], p = line_.pressure[j], density = line_.density[j];
    const bool wet = line_.wet[j] != 0;
    const double filled = wet ? 1.0 : std::clamp(flow_[j] / (density * velocities_.mean * h), least_filled, 1.0);
    across_.wet[l] = wet ? 1.0 : 0.0;
    across_.pressure[l] = p;
    across_.thickness[l] = h;
    across_.log_viscosity[l] = line_.log_viscosity[j] - log_ambient_;
    across_.half_gradient[l] = 0.5 * h * line_.gradient[j];
    across_.carried[l] = density * heat_by_step();
    across_.conductivity[l] = filled * model_.heat->oil.conductivity_at(p);
    across_.base_pinion[l] = model_.bodies[0].temperature + response_[0] * base_pinion_[j];
    across_.base_wheel[l] = model_.bodies[1].temperature + response_[1] * base_wheel_[j];
    across_.poiseuille_flow[l] = 0.0;
    across_.poiseuille_heat[l] = 0.0;
    across_.flow[l] = filled * velocities_.mean;
  }

  // Oil that a squeezed film throws back over the inlet takes its heat where the march does not go.
  void load_isothermal_flow(int l, int i, int j) {
    if (!line_.wet[j]) return;
    const double h = line_.thickness[j], p_x = line_.gradient[j];
    const double inverse_viscosity = std::exp(log_shear_factor(i, j, l) - line_.log_viscosity[j]);
    const double poiseuille = -h * h * p_x * inverse_viscosity / 12.0, back = -velocities_.mean;
    const double part = poiseuille < back ? back / poiseuille : 1.0;
    across_.poiseuille_flow[l] = part * poiseuille;
    across_.flow[l] = std::max(least_flow * velocities_.mean, velocities_.mean + across_.poiseuille_flow[l]);
    across_.poiseuille_heat[l] = part * part * h * h * p_x * p_x * inverse_viscosity;
    flow_[j] = line_.density[j] * across_.flow[l] * h;
  }

  /// ln F over theta (flow_correction.hpp).
  double by_thinning(int l) const { return 1.0 + inverse_span_ * across_.log_viscosity[l]; }

  /// theta and ln S with which the film was solved.
  double theta(int i, int j) const { return film_.correction().empty() ? 0.0 : film_.correction().thinning[at(i, j)]; }
  double log_shear_factor(int i, int j, int l) const {
    const FlowCorrection& flow = film_.correction();
    if (!flow.sheared) return 0.0;
    const double x = across_.log_viscosity[l] - theta(i, j) * by_thinning(l);
    return gearfilm::log_shear_factor(flow.shear_power, flow.shear[at(i, j)], x).value;
  }

  // At the last wet node of a row dp/dx = 0.
  void load_own_flow(int l, int i, int j) {
    const double log_S = log_shear_factor(i, j, l);
    across_.shear_factor[l] = std::exp(log_S);
    if (!line_.wet[j] || film_.pressure().row(i + 1)[j] <= 0.0) return;
    const double h = line_.thickness[j], log_factor = theta(i, j) * by_thinning(l) + log_S;
    across_.poiseuille_flow[l] = -h * h * line_.gradient[j] * std::exp(log_factor - line_.log_viscosity[j]) / 12.0;
  }

  /// rho_0 c/h_x [J/(m^4 K)].
  double heat_by_step() const { return model_.heat->oil.density * model_.heat->oil.heat_capacity / h_x_; }

  void load_profiles(int l, int i, int j) {
    const double *near = profile(i - 1, j), *far = profile(std::max(i - 2, 0), j);
    if (!own_) {
      for (int k = 0; k < points(); ++k) {
        across_.upstream[k][l] = near[k];
        across_.before[k][l] = line_.wet[j] ? 2.0 * near[k] - far[k] : near[k];
      }
      return;
    }
    // (3 T_i - 4 T_i-1 + T_i-2)/2 where the oil comes that way.
    const bool wet = line_.wet[j] && i > 1;
    const int last = grid_.nx() - 1;
    const double *next = profile(std::min(i + 1, last), j), *next_far = profile(std::min(i + 2, last), j);
    const double *returning = passing(std::min(i + 1, last), j), *returning_far = passing(std::min(i + 2, last), j);
    const double *passed = passing(i - 1, j), *passed_far = passing(std::max(i - 2, 0), j);
    const double* earlier = storage_ > 0.0 ? earlier_.data() + at(i, j) * points() : profile(i, j);
    across_.stored[l] = storage_ * line_.density[j];
    across_.step_factor[l] = wet ? 1.5 : 1.0;
    for (int k = 0; k < points(); ++k) {
      const bool second_order = wet && passed[k] > 0.0 && passed_far[k] > 0.0;
      across_.upstream_factor[k][l] = second_order ? 1.5 : 1.0;
      across_.upstream[k][l] = second_order ? (4.0 * near[k] - far[k]) / 3.0 : near[k];
      const bool returns = wet && storage_ == 0.0 && returning[k] < 0.0 && returning_far[k] < 0.0;
      across_.downstream_factor[k][l] = returns ? 1.5 : 1.0;
      across_.downstream[k][l] = returns ? (4.0 * next[k] - next_far[k]) / 3.0 : next[k];
      // That of the sweep before, changed as upstream.
      across_.before[k][l] = profile(i, j)[k] + (wet && !returning_ ? gain(j)[k] : 0.0);
      across_.earlier[k][l] = earlier[k];
      across_.arriving[k][l] = heat_by_step() * (wet ? 2.0 * passed[k] - 0.5 * passed_far[k] : passed[k]);
    }
  }

  void store_lane(int l, int i, int j) {
    const std::size_t node = at(i, j);
    double* T = profile(i, j);
    for (int k = 0; k < points(); ++k) {
      gain(j)[k] = across_.temperatures()[k][l] - T[k];
      T[k] = across_.temperatures()[k][l];
    }
    fields_.shear_stress[node] = std::copysign(across_.stress()[l], velocities_.sliding);
    fields_.heat_flux_pinion[node] = across_.heat_pinion(l);
    fields_.heat_flux_wheel[node] = across_.heat_wheel(l);
    fields_.heat_generated[node] = across_.heat_generated()[l];
    fields_.heat_carried[node] = across_.heat_carried()[l];
    if (across_.missed(l)) fields_.missed += 1.0;
    store_profile(i, j, across_.mean_temperature()[l], across_.largest_temperature()[l]);
    if (own_) store_flow(l, i, j);
  }

  void store_flow(int l, int i, int j) {
    const std::size_t node = at(i, j);
    const double mass = line_.density[j] * line_.thickness[j];
    double* passed = passing(i, j);
    for (int k = 0; k < points(); ++k) {
      passed[k] = mass * across_.speeds()[k][l];
      if (!returning_ && line_.wet[j] && passed[k] < 0.0) last_returning_ = i;
    }
    const ThermalOil& oil = model_.heat->oil;
    heat_.flow.density[node] =
        density_factor(film_.scales().oil, oil, line_.pressure[j], fields_.temperature_mean[node]);
    const double wedge = velocities_.sliding * (0.5 - across_.own_flow().centre[l]);
    fields_.log_flow_factor[node] = across_.own_flow().log_factor[l];
    heat_.flow.thinning[node] = across_.own_flow().log_factor[l] / by_thinning(l);
    heat_.flow.wedge[node] = wedge / film_.scales().operation.entrainment_velocity;
    if (model_.shear_in_film) {
      put_shear(model_.law, across_.log_newtonian(l), across_.half_gradient[l],
                across_.log_viscosity[l] - across_.own_flow().log_factor[l], node, heat_.flow);
    }
    if (line_.wet[j]) flow_[j] = mass * (velocities_.mean + wedge + across_.poiseuille_flow[l]);
  }

  /// Oil that enters between its walls.
  void store_entering(int i, int j) {
    store_profile(i, j, model_.heat->oil.temperature, *std::max_element(profile(i, j), profile(i, j) + points()));
  }

  void store_profile(int i, int j, double mean, double largest) {
    const std::size_t node = at(i, j);
    const double* T = profile(i, j);
    fields_.temperature_wheel[node] = T[0];
    fields_.temperature_pinion[node] = T[points() - 1];
    fields_.temperature_mean[node] = mean;
    fields_.temperature_mid[node] = T[points() / 2];
    fields_.temperature_max[node] = largest;
  }

  const Grid& grid_;
  const ContactFilm& film_;
  const TractionModel& model_;
  SurfaceVelocities velocities_;
  double log_ambient_;
  double inverse_span_;
  double h_x_;  // [m]
  bool own_;
  std::array<double, 2> response_;  // of pinion and wheel (moving_source.hpp)
  bool returning_ = false;          // on the way back
  double storage_ = 0.0;            // rho_0 c over the time step [W/(m^3 K)]; 0 at rest
  std::vector<double> earlier_;     // T_k a time step ago
  MovingSource source_;
  FilmLine line_;
  AcrossFilm across_;
  FilmHeat& heat_;
  std::vector<double> flow_;                      // rho/rho_0 times the mean flow of the last wet node of every row
  std::vector<double> base_pinion_, base_wheel_;  // sums of moving_source.hpp
  std::vector<double> gain_;
  int last_returning_ = 0;  // line where oil turns back
  TractionFields fields_;
};

}  // namespace

TractionFields heated_film(const TractionModel& model, const ContactFilm& film, const SurfaceVelocities& velocities) {
  FilmHeat heat;
  return HeatMarch(model, film, velocities, FilmFlow::isothermal, heat).march();
}

TractionFields sweep_heat(const TractionModel& model, const ContactFilm& film, const SurfaceVelocities& velocities,
                          FilmHeat& heat, std::optional<double> time_step) {
  return HeatMarch(model, film, velocities, FilmFlow::own, heat, time_step).march();
}

}  // namespace gearfilm
