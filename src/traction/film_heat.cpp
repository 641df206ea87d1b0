#include "traction/film_heat.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "gearfilm/error.hpp"
#include "lubricant/independent_iterations.hpp"
#include "traction/boundary_friction.hpp"
#include "traction/film_energy_equation.hpp"
#include "traction/film_line.hpp"
#include "traction/moving_source.hpp"
#include "traction/sheared_flow.hpp"

namespace gearfilm {
namespace {

constexpr double least_flow = 0.1;     // of u_m h
constexpr double least_filled = 1e-3;  // of a cavitated film

/// The march along x.
class HeatMarch {
public:
  HeatMarch(const TractionModel& model, const ContactFilm& film, FlowProfile flow, FilmHeat& heat,
            std::optional<double> time_step = {})
      : grid_(film.grid()),
        solved_(grid_.inner_rows()),
        film_(film),
        model_(model),
        log_ambient_(std::log(film.scales().oil.viscosity)),
        viscosity_(viscosity_evaluator(film.scales().oil)),
        heating_ratio_(film.grid().y_count()),
        h_x_(film.scales().length * grid_.h_x()),
        own_(flow == FlowProfile::thermal),
        source_(grid_.nx(), h_x_),
        line_(film),
        across_(model.law, film.scales().oil, *model.heat, flow),
        heat_(heat),
        flow_(rows(), HUGE_VAL),
        base_pinion_(rows()),
        base_wheel_(rows()),
        gain_(static_cast<std::size_t>(rows()) * points()) {
    const std::size_t nodes = grid_.local_size();
    fields_.boundary_stress = boundary_stress(model, film);
    contact_heat_ = fields_.boundary_stress;
    for (std::size_t n = 0; n < contact_heat_.size(); ++n) {
      contact_heat_[n] *= line_.velocities[n % line_.velocities.size()].sliding;
    }
    for (const SurfaceVelocities& u : line_.velocities) {
      response_pinion_.push_back(surface_response(model.bodies[0], u.pinion()));
      response_wheel_.push_back(surface_response(model.bodies[1], u.wheel()));
    }
    if (time_step) {
      storage_ = model.heat->oil.density * model.heat->oil.heat_capacity / *time_step;
      earlier_ = heat.temperatures;
    }
    if (heat.temperatures.empty()) heat.temperatures.assign(nodes * points(), model.heat->oil.temperature);
    std::fill_n(temperatures(0, 0), points() * rows(), model.heat->oil.temperature);
    std::fill_n(temperatures(0, 0), rows(), model.bodies[1].temperature);
    std::fill_n(temperatures(0, points() - 1), rows(), model.bodies[0].temperature);
    for (auto* field :
         {&fields_.shear_stress, &fields_.temperature_pinion, &fields_.temperature_wheel, &fields_.temperature_mean,
          &fields_.temperature_mid, &fields_.temperature_max, &fields_.heat_flux_pinion, &fields_.heat_flux_wheel,
          &fields_.heat_generated, &fields_.heat_carried}) {
      field->assign(nodes, 0.0);
    }
    if (!own_) return;
    heat.flow = FlowFactors::none(nodes);
    heat.flow.sheared = model.shear_couples_film;
    fields_.log_flow_factor.assign(nodes, 0.0);
    if (heat.passing.empty()) heat.passing.assign(nodes * points(), 0.0);
  }

  TractionFields march() {
    line_.load(0);
    for (int j = 0; j < rows(); ++j) {
      store_entering(0, j);
      const SurfaceVelocities& u = line_.velocities[j];
      for (int k = 0; own_ && k < points(); ++k) {
        const double place = static_cast<double>(k) / (points() - 1);
        passing(0, k)[j] = line_.density[j] * line_.thickness[j] * (u.wheel() + place * u.sliding);
      }
    }
    for (int i = 1; i < grid_.nx(); ++i) {
      for (int j = 0; j < rows(); ++j) {
        if (j < solved_.begin || j >= solved_.end) pass_unheated(i, j);
      }
      solve_line(i);
    }
    // Back again, so that what oil brings from downstream reaches the inlet in one sweep; in a time step it comes as
    // far as a step takes it.
    returning_ = true;
    for (int i = storage_ > 0.0 ? 0 : last_returning_; i > 0; --i) solve_line(i);
    if (const int central = grid_.local_row(grid_.row_axis().central()); central >= 0) {
      for (int i = 0; i < grid_.nx(); ++i) {
        for (int k = 0; k < points(); ++k) fields_.across.push_back(temperatures(i, k)[central]);
      }
    }
    return std::move(fields_);
  }

private:
  int rows() const { return grid_.y_count(); }
  int points() const { return model_.heat->points; }
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(i) * rows() + j; }
  std::size_t at_point(int i, int k) const { return rows_at_point(i, k, points(), rows()); }
  double* temperatures(int i, int k) { return heat_.temperatures.data() + at_point(i, k); }
  /// What a sweep changed on the line that was solved last.
  double* gain(int k) { return gain_.data() + at_point(0, k); }
  /// rho/rho_0 h u_k [m^2/s].
  double* passing(int i, int k) { return heat_.passing.data() + at_point(i, k); }

  void solve_line(int i) {
    line_.load(i);
    line_.load_flow(i);
    std::visit([&](const auto& viscosity) { find_heating_ratios(viscosity); }, viscosity_);
    source_.earlier(fields_.heat_flux_pinion, i, base_pinion_);
    source_.earlier(fields_.heat_flux_wheel, i, base_wheel_);
    for (int first = solved_.begin; first < solved_.end; first += FilmEnergyEquation::lanes) solve_rows(i, first);
  }

  /// In a row on an edge of the grid oil keeps the temperatures with which it entered.
  void pass_unheated(int i, int j) {
    for (int k = 0; k < points(); ++k) temperatures(i, k)[j] = temperatures(0, k)[j];
    store_entering(i, j);
  }

  void solve_rows(int i, int first) {
    // Lanes beyond the last row repeat it.
    for (int l = 0; l < FilmEnergyEquation::lanes; ++l) {
      const int j = std::min(first + l, solved_.end - 1);
      load_lane(l, j);
      if (!contact_heat_.empty()) {
        const double half = 0.5 * source_.own_weight() * contact_heat_[at(i, j)];
        across_.base_pinion[l] += response_pinion_[j] * half;
        across_.base_wheel[l] += response_wheel_[j] * half;
      }
      if (own_) {
        load_own_flow(l, i, j);
      } else {
        load_isothermal_flow(l, j);
      }
    }
    if (first + FilmEnergyEquation::lanes <= solved_.end) {
      load_profiles(i, [first](int l) { return first + l; });
    } else {
      load_profiles(i, [first, last = solved_.end - 1](int l) { return std::min(first + l, last); });
    }
    try {
      across_.solve();
    } catch (const SolveError& error) {
      std::ostringstream message;
      message << error.what() << " near x = " << grid_.x(i) << " a, y = " << grid_.y(first)
              << " a; use more points across the film (thermal_points) or a finer grid";
      throw SolveError(message.str());
    }
    const int count = std::min(FilmEnergyEquation::lanes, solved_.end - first);
    store_profiles(i, first, count);
    for (int l = 0; l < count; ++l) {
      if (changes(first + l)) store_lane(l, i, first + l);
    }
  }

  void load_lane(int l, int j) {
    const double h = line_.thickness[j], p = line_.pressure[j], density = line_.density[j];
    const bool full_film = line_.full_film[j] != 0;
    const SurfaceVelocities& u = line_.velocities[j];
    const double filled = full_film ? 1.0 : std::clamp(flow_[j] / (density * u.mean * h), least_filled, 1.0);
    across_.full_film[l] = full_film ? 1.0 : 0.0;
    across_.pressure[l] = p;
    across_.thickness[l] = h;
    across_.log_viscosity[l] = line_.log_viscosity[j] - log_ambient_;
    across_.half_gradient[l] = 0.5 * h * line_.gradient[j];
    across_.carried[l] = density * heat_by_step();
    across_.conductivity[l] = filled * model_.heat->oil.conductivity_at(p);
    across_.base_pinion[l] = model_.bodies[0].temperature + response_pinion_[j] * base_pinion_[j];
    across_.base_wheel[l] = model_.bodies[1].temperature + response_wheel_[j] * base_wheel_[j];
    across_.conductance_pinion[l] = 1.0 / (response_pinion_[j] * source_.own_weight());
    across_.conductance_wheel[l] = 1.0 / (response_wheel_[j] * source_.own_weight());
    across_.mean_velocity[l] = u.mean;
    across_.sliding[l] = u.sliding;
    across_.poiseuille_flow[l] = 0.0;
    across_.driven_flow[l] = 0.0;
    across_.poiseuille_heat[l] = 0.0;
    across_.flow[l] = filled * u.mean;
  }

  // Oil that a squeezed film throws back over the inlet takes its heat where the march does not go.
  void load_isothermal_flow(int l, int j) {
    if (!line_.full_film[j]) return;
    const double u_m = line_.velocities[j].mean, poiseuille = line_.poiseuille[j], back = -u_m;
    const double part = poiseuille < back ? back / poiseuille : 1.0;
    across_.poiseuille_flow[l] = part * poiseuille;
    across_.flow[l] = std::max(least_flow * u_m, u_m + across_.poiseuille_flow[l]);
    across_.poiseuille_heat[l] = std::max(0.0, -12.0 * part * part * poiseuille * line_.gradient[j]);
    flow_[j] = line_.density[j] * across_.flow[l] * line_.thickness[j];
  }

  /// g of the line, ln F over theta (flow_factors.hpp).
  template <EvaluatesViscosity Viscosity>
  void find_heating_ratios(Viscosity viscosity) {
    const int count = rows();
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < count; ++j) {
      heating_ratio_[j] = viscosity.heating_ratio(line_.log_viscosity[j] - log_ambient_, line_.pressure[j]).value;
    }
  }

  /// theta and ln S with which the film was solved.
  double theta(int i, int j) const {
    return film_.flow_factors().empty() ? 0.0 : film_.flow_factors().log_poiseuille[at(i, j)];
  }
  double log_shear_factor(int i, int j, int l) const {
    const FlowFactors& flow = film_.flow_factors();
    if (!flow.sheared) return 0.0;
    const double x = across_.log_viscosity[l] - theta(i, j) * heating_ratio_[j];
    return gearfilm::log_shear_factor(flow.shear_power, flow.shear_index[at(i, j)], x).value;
  }

  // At the last full node of a row dp/dx = 0.
  void load_own_flow(int l, int i, int j) {
    const double log_S = log_shear_factor(i, j, l);
    across_.shear_factor[l] = std::exp(log_S);
    if (!line_.full_film[j] || film_.film_pressure().row(i + 1)[j] <= 0.0) return;
    const double h = line_.thickness[j], log_factor = theta(i, j) * heating_ratio_[j] + log_S;
    across_.poiseuille_flow[l] = line_.poiseuille[j];
    across_.driven_flow[l] = -h * h * line_.gradient[j] * std::exp(log_factor - line_.log_viscosity[j]) / 12.0;
  }

  /// rho_0 c/h_x [J/(m^4 K)].
  double heat_by_step() const { return model_.heat->oil.density * model_.heat->oil.heat_capacity / h_x_; }

  /// row: of a lane.
  template <class Row>
  void load_profiles(int i, Row row) {
    if (own_) {
      load_own_profiles(i, row);
    } else {
      load_isothermal_profiles(i, row);
    }
  }

  template <class Row>
  void load_isothermal_profiles(int i, Row row) {
    for (int k = 0; k < points(); ++k) {
      const double *T_before = temperatures(i - 1, k), *T_far = temperatures(std::max(i - 2, 0), k);
      each_lane([&](int l) {
        const double T = T_before[row(l)];
        across_.upstream[k][l] = T;
        across_.before[k][l] = T + across_.full_film[l] * (T - T_far[row(l)]);
      });
    }
  }

  template <class Row>
  void load_own_profiles(int i, Row row) {
    // (3 T_i - 4 T_i-1 + T_i-2)/2 where the oil comes that way.
    const int before = i - 1, far = std::max(i - 2, 0), last = grid_.nx() - 1;
    const int next = std::min(i + 1, last), next_far = std::min(i + 2, last);
    const bool resting = storage_ == 0.0;
    const double here = i > 1 ? 1.0 : 0.0, guessed = returning_ ? 0.0 : here;
    each_lane([&](int l) {
      across_.stored[l] = storage_ * line_.density[row(l)];
      across_.step_factor[l] = 1.0 + 0.5 * here * across_.full_film[l];
    });
    for (int k = 0; k < points(); ++k) {
      const double *T_before = temperatures(before, k), *T_far = temperatures(far, k), *T = temperatures(i, k);
      const double *T_next = temperatures(next, k), *T_next_far = temperatures(next_far, k), *gained = gain(k);
      const double* T_earlier = resting ? T : earlier_.data() + at_point(i, k);
      const double *passed = passing(before, k), *passed_far = passing(far, k);
      const double *returned = passing(next, k), *returned_far = passing(next_far, k);
      each_lane([&](int l) {
        const int j = row(l);
        const double full_film = here * across_.full_film[l];
        const double arrives = (passed[j] > 0.0) & (passed_far[j] > 0.0) ? full_film : 0.0;
        across_.upstream_factor[k][l] = 1.0 + 0.5 * arrives;
        across_.upstream[k][l] = T_before[j] + arrives * (1.0 / 3.0) * (T_before[j] - T_far[j]);
        const double returns = resting & (returned[j] < 0.0) & (returned_far[j] < 0.0) ? full_film : 0.0;
        across_.downstream_factor[k][l] = 1.0 + 0.5 * returns;
        across_.downstream[k][l] = T_next[j] + returns * (1.0 / 3.0) * (T_next[j] - T_next_far[j]);
        // That of the sweep before, changed as upstream.
        across_.before[k][l] = T[j] + guessed * across_.full_film[l] * gained[j];
        across_.earlier[k][l] = T_earlier[j];
        across_.arriving[k][l] = heat_by_step() * (passed[j] + full_film * (passed[j] - 0.5 * passed_far[j]));
      });
    }
  }

  /// On the way back what the cavitated film has stays.
  bool changes(int j) const { return !returning_ || line_.full_film[j]; }

  void store_profiles(int i, int first, int count) {
    for (int k = 0; k < points(); ++k) {
      const FilmEnergyEquation::Lanes& found = across_.temperatures()[k];
      double *T = temperatures(i, k) + first, *gained = gain(k) + first;
      for (int l = 0; l < count; ++l) {
        if (!changes(first + l)) continue;
        gained[l] = found[l] - T[l];
        T[l] = found[l];
      }
    }
    for (int k = 0; own_ && k < points(); ++k) {
      const FilmEnergyEquation::Lanes& speed = across_.speeds()[k];
      double* passed = passing(i, k) + first;
      bool turns = false;
      for (int l = 0; l < count; ++l) {
        if (!changes(first + l)) continue;
        passed[l] = line_.density[first + l] * line_.thickness[first + l] * speed[l];
        turns = turns || (across_.full_film[l] * passed[l] < 0.0);
      }
      if (turns && !returning_) last_returning_ = i;
    }
  }

  void store_lane(int l, int i, int j) {
    const std::size_t node = at(i, j);
    fields_.shear_stress[node] = std::copysign(across_.stress()[l], line_.velocities[j].sliding);
    const double rubbed = contact_heat_.empty() ? 0.0 : contact_heat_[node];
    fields_.heat_flux_pinion[node] = across_.heat_pinion(l) + 0.5 * rubbed;
    fields_.heat_flux_wheel[node] = across_.heat_wheel(l) + 0.5 * rubbed;
    fields_.heat_generated[node] = across_.heat_generated()[l] + rubbed;
    fields_.heat_carried[node] = across_.heat_carried()[l];
    if (across_.unconverged(l)) fields_.unconverged_nodes += 1.0;
    store_temperatures(i, j, across_.mean_temperature()[l], across_.largest_temperature()[l]);
    if (own_) store_flow(l, i, j);
  }

  void store_flow(int l, int i, int j) {
    const std::size_t node = at(i, j);
    const double mass = line_.density[j] * line_.thickness[j];
    const ThermalOil& oil = model_.heat->oil;
    heat_.flow.density_ratio[node] =
        density_factor(film_.scales().oil, oil, line_.pressure[j], fields_.temperature_mean[node]);
    const double wedge = line_.velocities[j].sliding * (0.5 - across_.own_flow().centre[l]);
    fields_.log_flow_factor[node] = across_.own_flow().log_factor[l];
    heat_.flow.log_poiseuille[node] = across_.own_flow().log_factor[l] / heating_ratio_[j];
    heat_.flow.entrainment_excess[node] = wedge / film_.scales().operation.entrainment_velocity;
    if (model_.shear_couples_film) {
      put_shear(model_.law, across_.log_newtonian(l), across_.half_gradient[l],
                across_.log_viscosity[l] - across_.own_flow().log_factor[l], node, heat_.flow);
    }
    if (line_.full_film[j]) flow_[j] = mass * (line_.velocities[j].mean + wedge + across_.poiseuille_flow[l]);
  }

  /// Oil that enters between its walls.
  void store_entering(int i, int j) {
    const ThermalOil& oil = model_.heat->oil;
    store_temperatures(i, j, oil.temperature,
                       std::max({oil.temperature, temperatures(i, 0)[j], temperatures(i, points() - 1)[j]}));
  }

  void store_temperatures(int i, int j, double mean, double largest) {
    const std::size_t node = at(i, j);
    fields_.temperature_wheel[node] = temperatures(i, 0)[j];
    fields_.temperature_pinion[node] = temperatures(i, points() - 1)[j];
    fields_.temperature_mean[node] = mean;
    fields_.temperature_mid[node] = temperatures(i, points() / 2)[j];
    fields_.temperature_max[node] = largest;
  }

  const Grid& grid_;
  RowRange solved_;  ///< own rows that are not on an edge of the grid
  const ContactFilm& film_;
  const TractionModel& model_;
  double log_ambient_;
  ViscosityEvaluator viscosity_;
  std::vector<double> heating_ratio_;  // g of the nodes of a line
  double h_x_;                         // [m]
  bool own_;
  std::vector<double> response_pinion_, response_wheel_;  // of every row (moving_source.hpp)
  bool returning_ = false;                                // on the way back
  double storage_ = 0.0;                                  // rho_0 c over the time step [W/(m^3 K)]; 0 at rest
  std::vector<double> earlier_;                           // T_k a time step ago
  MovingSource source_;
  FilmLine line_;
  FilmEnergyEquation across_;
  FilmHeat& heat_;
  std::vector<double> flow_;                      // rho/rho_0 times the mean flow of the last full node of every row
  std::vector<double> base_pinion_, base_wheel_;  // sums of moving_source.hpp
  std::vector<double> gain_;
  std::vector<double> contact_heat_;  // of asperities that rub [W/m^2]; empty between smooth surfaces
  int last_returning_ = 0;            // line where oil turns back
  TractionFields fields_;
};

}  // namespace

TractionFields heated_film(const TractionModel& model, const ContactFilm& film) {
  FilmHeat heat;
  return HeatMarch(model, film, FlowProfile::isothermal, heat).march();
}

TractionFields sweep_heat(const TractionModel& model, const ContactFilm& film, FilmHeat& heat,
                          std::optional<double> time_step) {
  return HeatMarch(model, film, FlowProfile::thermal, heat, time_step).march();
}

}  // namespace gearfilm
