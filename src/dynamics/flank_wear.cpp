#include "dynamics/flank_wear.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace gearfilm {
namespace {

constexpr double reach = 2.0;  // of a contact [a]

/// A coordinate between two of n equidistant places; beyond the ends it is at the end.
struct Between {
  std::size_t first;
  double weight;  ///< of the second
};
Between between(double at, double begin, double end, int n) {
  const double place = std::clamp((at - begin) / (end - begin) * (n - 1), 0.0, n - 1.0);
  const double first = std::min(std::floor(place), n - 2.0);
  return {static_cast<std::size_t>(first), place - first};
}

/// Parts of a strip from one y to another that belong to the places across a flank; what is beyond the face belongs to
/// its edge.
std::vector<double> parts_of_strip(const FlankPlaces& places, double from, double to) {
  std::vector<double> parts(static_cast<std::size_t>(places.across), 0.0);
  const double half = places.half_width / (places.across - 1);
  for (int j = 0; j < places.across; ++j) {
    const double lower = j == 0 ? -HUGE_VAL : places.y(j) - half;
    const double upper = j == places.across - 1 ? HUGE_VAL : places.y(j) + half;
    parts[static_cast<std::size_t>(j)] = std::max(0.0, std::min(to, upper) - std::max(from, lower)) / (to - from);
  }
  return parts;
}

/// The same of a row of the grid and its mirror image, if it has one.
std::vector<double> parts_of_row(const FlankPlaces& places, const Grid& grid, int j, double length) {
  const Strip strip = grid.row_axis().strip(grid.y_begin() + j);
  std::vector<double> parts = parts_of_strip(places, length * strip.lower, length * strip.upper);
  if (!grid.row_axis().mirrored()) return parts;
  const std::vector<double> image = parts_of_strip(places, -length * strip.upper, -length * strip.lower);
  for (std::size_t n = 0; n < parts.size(); ++n) parts[n] = 0.5 * (parts[n] + image[n]);
  return parts;
}

void deposit(const FlankPlaces& places, FlankVolumes& volumes, double s, std::span<const double> across,
             double volume) {
  const Between along = between(s, places.begin, places.end, places.along);
  double* first = volumes.data() + along.first * across.size();
  for (std::size_t n = 0; n < across.size(); ++n) {
    first[n] += (1.0 - along.weight) * across[n] * volume;
    first[n + across.size()] += along.weight * across[n] * volume;
  }
}

}  // namespace

FlankWear::FlankWear(const MeshModel& mesh, double face_width, int along, int across) : mesh_(mesh) {
  const LineOfAction& line = mesh.path.line();
  const std::array<double, 2> entry = line.involute_lengths(line.entry()), exit = line.involute_lengths(line.exit());
  // A contact at an end of the path reaches beyond it.
  const double beside = reach * mesh.scales.length;
  const auto along_flank = [&](double from, double to) {
    return FlankPlaces{std::max(0.1 * from, from - beside), to + beside, 0.5 * face_width, along, across};
  };
  places_[0] = along_flank(entry[0], exit[0]);
  places_[1] = along_flank(exit[1], entry[1]);
  for (auto* volumes : {&lost_, &rate_, &last_rate_})
    volumes->fill(FlankVolumes(static_cast<std::size_t>(along) * static_cast<std::size_t>(across), 0.0));
}

void FlankWear::add_rates(const ActiveContact& contact, double T) {
  const ContactFilm& film = *contact.film;
  if (!film.state().rough) throw std::logic_error("flanks without asperities do not wear");
  const Grid& grid = film.grid();
  const Scales& scales = mesh_.scales;
  const MeshedContact at = mesh_.contact(contact.number, T);
  const std::array<double, 2> middle = mesh_.path.line().involute_lengths(at.position);
  const double sliding = velocities_of(scales, at).sliding;
  const double unit = mesh_.load_factor() * scales.pressure * scales.length * scales.length * grid.h_x();
  for (int j = 0; j < grid.y_count(); ++j) {
    const std::vector<double> across = parts_of_row(places_[0], grid, j, scales.length);
    const double of_row = unit * grid.row_weights()[static_cast<std::size_t>(j)];
    for (int i = 0; i < grid.nx(); ++i) {
      const double P_a = asperity_pressure(*film.state().rough, film.total_pressure(), i, j);
      if (P_a == 0.0) continue;
      const double x = grid.x(i) * scales.length, force = of_row * P_a;
      deposit(places_[0], rate_[0], middle[0] - x, across, wear_rate(mesh_.wear->pinion, sliding, force));
      deposit(places_[1], rate_[1], middle[1] + x, across, wear_rate(mesh_.wear->wheel, sliding, force));
    }
  }
}

void FlankWear::add(const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  if (record.replayed) throw std::logic_error("a step that is replayed has no films");
  for (FlankVolumes& rate : rate_) std::ranges::fill(rate, 0.0);
  for (const ActiveContact& contact : contacts) add_rates(contact, record.T);
  const double duration = record.dT * mesh_.scales.time;
  for (std::size_t gear = 0; gear < lost_.size(); ++gear) {
    for (std::size_t n = 0; n < lost_[gear].size(); ++n)
      lost_[gear][n] += 0.5 * duration * (last_rate_[gear][n] + rate_[gear][n]);
  }
  std::swap(rate_, last_rate_);
}

std::array<FlankVolumes, 2> FlankWear::take(MPI_Comm comm) {
  std::array<FlankVolumes, 2> all = lost_;
  for (std::size_t gear = 0; gear < all.size(); ++gear) {
    MPI_Allreduce(MPI_IN_PLACE, all[gear].data(), static_cast<int>(all[gear].size()), MPI_DOUBLE, MPI_SUM, comm);
    std::ranges::fill(lost_[gear], 0.0);
  }
  return all;
}

}  // namespace gearfilm
