#include "dynamics/heat_process.hpp"

#include <algorithm>

#include "traction/coupled_film.hpp"

namespace gearfilm {
namespace {

// A step of no length: temperatures stay, and make their friction.
constexpr double moment = 1e-15;  // [s]

// Where sliding begins or ends shear thins the middle of the contact by many decades at once: kappa follows by so much
// a step, and is extrapolated by no more than a quarter of that.
constexpr double largest_shear_step = 4.0, most_shear = 1.0;

/// Flow factors at the end of the next time step, by those at both ends of the last one, of the same length.
FlowFactors extrapolated(const FlowFactors& before, const FlowFactors& now) {
  FlowFactors next = now;
  for (std::size_t n = 0; n < next.entrainment_excess.size(); ++n) {
    next.log_poiseuille[n] += now.log_poiseuille[n] - before.log_poiseuille[n];
    next.entrainment_excess[n] += now.entrainment_excess[n] - before.entrainment_excess[n];
    next.density_ratio[n] += now.density_ratio[n] - before.density_ratio[n];
    next.shear_index[n] += std::clamp(now.shear_index[n] - before.shear_index[n], -most_shear, most_shear);
    next.cross_flow[n] = std::max(2.0 * now.cross_flow[n] - before.cross_flow[n], 0.5 * now.cross_flow[n]);
  }
  return next;
}

void follow_shear(const FlowFactors& before, FlowFactors& now) {
  for (std::size_t n = 0; n < now.shear_index.size(); ++n) {
    now.shear_index[n] = std::clamp(now.shear_index[n], before.shear_index[n] - largest_shear_step,
                                    before.shear_index[n] + largest_shear_step);
  }
}

std::string name_of(int point) { return std::string(field::heat) + std::to_string(point); }

}  // namespace

void HeatProcess::begin(ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
                        StationaryResult& found) {
  CoupledFilm heated = solve_coupled(film, load, options, model_, found);
  found = std::move(heated.film);
  heat_ = std::move(heated.heat);
}

void HeatProcess::advance(ContactFilm& film, double dT) {
  const FlowFactors before = heat_.flow;
  of_step_ = std::make_shared<Traction>(coupled_traction(model_, film, heat_, dT * film.scales().time));
  follow_shear(before, heat_.flow);
  film.set_flow_factors(extrapolated(before, heat_.flow));
}

std::shared_ptr<const Traction> HeatProcess::traction(const ContactFilm& film) const {
  if (of_step_) return of_step_;
  FilmHeat still = heat_;
  return std::make_shared<Traction>(coupled_traction(model_, film, still, moment));
}

void HeatProcess::save(const Grid& grid, ContactFields& fields) const {
  if (model_.heats_film()) {
    const ThermalOil& oil = model_.heat->oil;
    const std::size_t points = model_.heat->points, rows = grid.y_count();
    for (std::size_t k = 0; k < points; ++k) {
      std::vector<double>& values = fields[name_of(static_cast<int>(k))];
      values.resize(heat_.flow.entrainment_excess.size());
      for (std::size_t i = 0; i * rows < values.size(); ++i) {
        const double* T = heat_.temperatures.data() + rows_at_point(i, k, points, rows);
        for (std::size_t j = 0; j < rows; ++j) {
          values[i * rows + j] = oil.temperature_viscosity * (T[j] - oil.temperature);
        }
      }
    }
  }
  for (const auto& known : field::correction) fields[std::string(known.field.name)] = heat_.flow.*known.values;
}

void HeatProcess::restore(ContactFilm& film, const ContactFields& fields) {
  heat_ = {};
  of_step_.reset();
  for (const auto& known : field::correction) heat_.flow.*known.values = values_of(fields, known.field);
  heat_.flow.shear_power = thinning_power(model_.law);
  heat_.flow.sheared = model_.shear_couples_film;
  film.set_flow_factors(heat_.flow);
  if (!model_.heats_film()) return;
  const ThermalOil& oil = model_.heat->oil;
  const std::size_t points = model_.heat->points, rows = film.grid().y_count();
  heat_.temperatures.resize(heat_.flow.entrainment_excess.size() * points);
  for (std::size_t k = 0; k < points; ++k) {
    const std::vector<double>& values = fields.at(name_of(static_cast<int>(k)));
    for (std::size_t i = 0; i * rows < values.size(); ++i) {
      double* T = heat_.temperatures.data() + rows_at_point(i, k, points, rows);
      for (std::size_t j = 0; j < rows; ++j) T[j] = oil.temperature + values[i * rows + j] / oil.temperature_viscosity;
    }
  }
}

}  // namespace gearfilm
