#include "stress/largest_stresses.hpp"

#include <algorithm>
#include <numbers>

namespace gearfilm {
namespace {

constexpr std::size_t values_of_a_depth = 4;

/// Von Mises stress, largest shear, half range of tau_xz and, at the surface, largest principal stress over the lines.
std::array<double, values_of_a_depth> largest(const SectionStress& section, int depth, bool at_surface) {
  double equivalent = 0.0, shear = 0.0, principal = 0.0, low = 0.0, high = 0.0;
  for (int line = 0; line < section.lines(); ++line) {
    const Stress stress = section.at(depth, line);
    const double of_line = von_mises(stress);
    equivalent = std::max(equivalent, of_line);
    // Principal values take angles: tau_1 <= sigma_v/3^(1/2).
    constexpr double most = 1.0 / std::numbers::sqrt3 + 1e-9;
    if (most * of_line > shear) shear = std::max(shear, largest_shear_stress(stress));
    if (at_surface) principal = std::max(principal, largest_principal(stress));
    low = std::min(low, stress.xz);
    high = std::max(high, stress.xz);
  }
  return {equivalent, shear, 0.5 * (high - low), principal};
}

}  // namespace

StressProfiles stress_profiles(const RowStress& row, const SectionStresses& sections) {
  const std::size_t depths = row.depths().size();
  const RowRange own = row.own_depths();
  std::vector<double> values(body_count * depths * values_of_a_depth, 0.0);
  for (std::size_t body = 0; body < body_count; ++body) {
    for (int depth = own.begin; depth < own.end; ++depth) {
      std::ranges::copy(largest(sections[body], depth - own.begin, depth == 0),
                        values.begin() + (body * depths + depth) * values_of_a_depth);
    }
  }
  // Zeros but on one process.
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM, row.comm());
  StressProfiles profiles;
  for (std::size_t body = 0; body < body_count; ++body) {
    const double* at = values.data() + body * depths * values_of_a_depth;
    profiles[body].surface_tension = at[3];
    for (std::size_t depth = 0; depth < depths; ++depth, at += values_of_a_depth) {
      profiles[body].von_mises.push_back(at[0]);
      profiles[body].largest_shear.push_back(at[1]);
      profiles[body].orthogonal_shear.push_back(at[2]);
    }
  }
  return profiles;
}

LargestStresses largest_stresses(const StressProfile& profile, std::span<const double> depths) {
  return {.von_mises = largest_between(depths, profile.von_mises),
          .largest_shear = largest_between(depths, profile.largest_shear),
          .orthogonal_shear = largest_between(depths, profile.orthogonal_shear),
          .surface_tension = profile.surface_tension};
}

}  // namespace gearfilm
