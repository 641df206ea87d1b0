#include "dynamics/contact_maps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fatigue/flank_map.hpp"
#include "traction/film_line.hpp"

namespace gearfilm {
namespace {

constexpr double touches = 0.01;  // of p_h: where a surface slides under the other

double spacing(const FlankPath& path, int points) { return (path.highest() - path.lowest()) / (points - 1); }

/// Rows at one place from those at the nodes: the larger and the smaller ones, and a part of them added.
void keep_larger(double* at, const double* values, int rows) {
  for (int j = 0; j < rows; ++j) at[j] = std::max(at[j], values[j]);
}
void keep_smaller(double* at, const double* values, int rows) {
  for (int j = 0; j < rows; ++j) at[j] = std::min(at[j], values[j]);
}
void add_part(double* at, double part, const std::vector<double>& values) {
  for (std::size_t j = 0; j < values.size(); ++j) at[j] += part * values[j];
}

}  // namespace

ContactMaps::ContactMaps(const MeshModel& mesh, int points, std::optional<double> period)
    : mesh_(mesh),
      points_(points),
      period_(period),
      paths_{FlankPath(mesh.path.line(), true), FlankPath(mesh.path.line(), false)} {}

void ContactMaps::begin_anew() {
  const std::size_t size = places() * static_cast<std::size_t>(grid_->y_count());
  for (Own& own : own_) {
    own.pressure.assign(size, 0.0);
    own.film.assign(size, std::numeric_limits<double>::infinity());
    own.temperature.assign(size, 0.0);
    own.energy.assign(size, 0.0);
    own.sliding.assign(size, 0.0);
    own.energy_rate.resize(size, 0.0);
    own.sliding_rate.resize(size, 0.0);
    own.next_energy_rate.resize(size, 0.0);
    own.next_sliding_rate.resize(size, 0.0);
  }
}

std::vector<double> ContactMaps::whole(const std::vector<double>& own) const {
  const auto rows = static_cast<std::size_t>(grid_->rows()), count = static_cast<std::size_t>(grid_->y_count());
  std::vector<double> all(places() * rows, 0.0);
  for (std::size_t k = 0; k < places(); ++k) {
    std::copy_n(own.data() + k * count, count, all.data() + k * rows + static_cast<std::size_t>(grid_->y_begin()));
  }
  // Zeros but on one process.
  MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM, grid_->comm());
  return all;
}

std::vector<double> ContactMaps::values() const {
  if (!grid_) return {};
  std::vector<double> all{begin_, last_};
  for (const Own& own : own_) {
    for (const auto* kept : own.kept()) {
      const std::vector<double> known = whole(*kept);
      all.insert(all.end(), known.begin(), known.end());
    }
  }
  return all;
}

void ContactMaps::take(const std::vector<double>& values, const Grid& grid) {
  if (values.empty()) return;
  grid_.emplace(grid);
  begin_anew();
  begin_ = values[0];
  last_ = values[1];
  const auto rows = static_cast<std::size_t>(grid.rows()), count = static_cast<std::size_t>(grid.y_count());
  const double* next = values.data() + 2;
  for (Own& own : own_) {
    for (auto* kept : own.kept()) {
      for (std::size_t k = 0; k < places(); ++k, next += rows) {
        std::copy_n(next + grid.y_begin(), count, kept->data() + k * count);
      }
    }
  }
}

/// Rows of a domain that has become wider, or that is cut in another way, take over what is known.
void ContactMaps::lay_on(const Grid& grid) {
  if (grid_ && grid_->shape() == grid.shape()) return;
  const ContactMaps before = *this;
  grid_.emplace(grid);
  for (Own& own : own_) own = {};
  begin_anew();
  if (!before.grid_) return;
  const RowAxis &old_rows = before.grid_->row_axis(), &rows = grid.row_axis();
  const int shift = old_rows == rows ? 0 : rows_between(rows, old_rows);
  const auto count = static_cast<std::size_t>(grid.y_count());
  for (std::size_t body = 0; body < own_.size(); ++body) {
    const auto from = before.own_[body].kept();
    const auto to = own_[body].kept();
    for (std::size_t n = 0; n < to.size(); ++n) {
      const std::vector<double> known = before.whole(*from[n]);
      for (std::size_t j = 0; j < count; ++j) {
        const int old_row = grid.y_begin() + static_cast<int>(j) - shift;
        if (old_row < 0 || old_row >= old_rows.count()) continue;
        for (std::size_t k = 0; k < places(); ++k) {
          (*to[n])[k * count + j] =
              known[k * static_cast<std::size_t>(old_rows.count()) + static_cast<std::size_t>(old_row)];
        }
      }
    }
  }
}

ContactMaps::Along ContactMaps::along(std::size_t body, double s) const {
  const FlankPath& path = paths_[body];
  const auto beyond = static_cast<std::size_t>(points_);
  const double place = (s - path.lowest()) / spacing(path, points_);
  if (!(place >= 0.0) || place > points_ - 1) return {beyond, beyond, beyond, 0.0};
  const auto first = static_cast<std::size_t>(std::min(static_cast<int>(place), points_ - 2));
  const double of_second = place - static_cast<double>(first);
  return {first + (of_second > 0.5 ? 1 : 0), first, first + 1, of_second};
}

void ContactMaps::add_contact(const ActiveContact& contact, double T) {
  const ContactFilm& film = *contact.film;
  const Scales& scales = mesh_.scales;
  const double xi = mesh_.contact(contact.number, T).position;
  const std::vector<SurfaceVelocities> velocities = row_velocities(film);
  const std::shared_ptr<const Traction> friction =
      mesh_.traction ? friction_of_step(*mesh_.traction, contact, T) : nullptr;
  const std::array temperature{friction ? friction->fields.temperature_pinion.data() : nullptr,
                               friction ? friction->fields.temperature_wheel.data() : nullptr};
  const bool heated = friction && !friction->fields.temperature_pinion.empty();
  const int rows = grid_->y_count();
  std::vector<double> power(rows, 0.0), speed(rows);
  for (int i = 0; i < grid_->nx(); ++i) {
    const double *P = film.total_pressure().row(i), *H = film.thickness().row(i);
    const std::size_t first = static_cast<std::size_t>(i) * rows;
    for (int j = 0; j < rows; ++j) {
      const double sliding = velocities[j].sliding;
      speed[j] = P[j] > touches ? std::abs(sliding) : 0.0;
      if (friction) power[j] = sliding * friction->fields.shear_stress[first + j];
      if (friction && !friction->fields.boundary_stress.empty())
        power[j] += sliding * friction->fields.boundary_stress[first + j];
    }
    for (std::size_t body = 0; body < own_.size(); ++body) {
      Own& own = own_[body];
      const Along at = along(body, paths_[body].point(grid_->x(i) * scales.length, xi));
      const std::size_t nearest = at.nearest * rows;
      keep_larger(own.pressure.data() + nearest, P, rows);
      keep_smaller(own.film.data() + nearest, H, rows);
      if (heated) keep_larger(own.temperature.data() + nearest, temperature[body] + first, rows);
      add_part(own.next_energy_rate.data() + at.first * rows, 1.0 - at.of_second, power);
      add_part(own.next_energy_rate.data() + at.second * rows, at.of_second, power);
      add_part(own.next_sliding_rate.data() + at.first * rows, 1.0 - at.of_second, speed);
      add_part(own.next_sliding_rate.data() + at.second * rows, at.of_second, speed);
    }
  }
}

void ContactMaps::add(const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  if (record.replayed || contacts.empty()) return;
  lay_on(contacts.front().film->grid());
  const double before = record.T - record.dT;
  if (period_ && record.dT > 0.0 && std::abs(std::remainder(before, *period_)) < 1e-9 * *period_) {
    begin_anew();
    begin_ = before;
  }
  for (Own& own : own_) {
    std::ranges::fill(own.next_energy_rate, 0.0);
    std::ranges::fill(own.next_sliding_rate, 0.0);
  }
  for (const ActiveContact& contact : contacts) add_contact(contact, record.T);
  const double half = 0.5 * record.dT * mesh_.scales.time;
  for (Own& own : own_) {
    for (std::size_t n = 0; n < own.energy.size(); ++n) {
      own.energy[n] += half * (own.energy_rate[n] + own.next_energy_rate[n]);
      own.sliding[n] += half * (own.sliding_rate[n] + own.next_sliding_rate[n]);
    }
    std::swap(own.energy_rate, own.next_energy_rate);
    std::swap(own.sliding_rate, own.next_sliding_rate);
  }
  last_ = record.T;
}

ContactMap ContactMaps::map_of(std::size_t body, double periods) const {
  const RowAxis& axis = grid_->row_axis();
  const Scales& scales = mesh_.scales;
  const FlankPath& path = paths_[body];
  const Own& own = own_[body];
  ContactMap map;
  map.s = flank_points(path, points_);
  for (const double s : map.s) {
    map.xi.push_back(path.position_of(s));
    map.radius.push_back(path.curvature_radius(map.xi.back()));
  }
  for (int row = 0; row < axis.whole_count(); ++row) map.y.push_back(scales.length * axis.whole_y(row));
  const auto rows = static_cast<std::size_t>(axis.count());
  const double step = grid_->h_x() * scales.length;
  const std::vector<double> film = whole(own.film);
  const auto all_rows = [&](const std::vector<double>& stored, const auto& scale) {
    std::vector<double> values;
    values.reserve(map.s.size() * map.y.size());
    for (std::size_t k = 0; k < map.s.size(); ++k) {
      for (int row = 0; row < axis.whole_count(); ++row) {
        const std::size_t n = k * rows + static_cast<std::size_t>(axis.stored_row(row));
        // Where no contact has been nothing is known.
        values.push_back(std::isfinite(film[n]) ? scale(k) * stored[n] : std::numeric_limits<double>::quiet_NaN());
      }
    }
    return values;
  };
  const auto by = [](double factor) { return [factor](std::size_t) { return factor; }; };
  const auto of_passage = [&](std::size_t k) {
    const double length = spacing(path, points_) * (k == 0 || k + 1 == map.s.size() ? 0.5 : 1.0);
    return step / length / periods;
  };
  const std::vector<double> energy = whole(own.energy);
  map.pressure = all_rows(whole(own.pressure), by(scales.pressure));
  map.film = all_rows(film, by(scales.thickness));
  map.sliding = all_rows(whole(own.sliding), of_passage);
  if (mesh_.traction) map.energy = all_rows(energy, of_passage);
  if (mesh_.traction && mesh_.traction->heat) map.temperature = all_rows(whole(own.temperature), by(1.0));
  const double width = axis.single() ? 1.0 : scales.length;
  for (std::size_t j = 0; j < rows; ++j) {
    map.energy_beyond += step / periods * width * axis.weight(static_cast<int>(j)) * energy[map.s.size() * rows + j];
  }
  return map;
}

std::optional<ContactMapPair> ContactMaps::maps() const {
  if (!grid_ || !(last_ > begin_)) return {};
  const double periods = mesh_.load ? 1.0 : mesh_.path.mesh_periods(last_) - mesh_.path.mesh_periods(begin_);
  return ContactMapPair{map_of(0, periods), map_of(1, periods)};
}

}  // namespace gearfilm
