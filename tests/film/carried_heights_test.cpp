// How heights of the flanks are carried through a contact: in closed form, so that differences cannot damp them.
#include "film/carried_heights.hpp"

#include <gtest/gtest.h>

#include "film_case.hpp"

namespace gearfilm {
namespace {

/// A circular contact between flanks with waves of a third of the half-axis a, well within its ellipse.
struct WavyContact {
  explicit WavyContact(const AnyDensityLaw& density) {
    contact.scales.oil.density_law = density;
    const auto waves = [&](double amplitude, double length, double remaining) {
      return Topography(Waviness{amplitude * contact.scales.thickness, length * contact.scales.length, 0.3}, {}, {},
                        remaining);
    };
    flanks =
        std::make_shared<const std::array<Topography, 2>>(std::array{waves(0.02, 0.35, 0.8), waves(0.03, 0.3, 0.6)});
  }

  /// q and D q at the time T.
  CarriedHeights at(const Grid& grid, double T, double sliding) const {
    const double a = contact.scales.length;
    return carried_heights(
        grid, contact.scales,
        {.entrainment = U,
         .sliding = sliding,
         .texture = {flanks, {5e-3 + (U + 0.5 * sliding) * T * a, 3e-3 - (U - 0.5 * sliding) * T * a}, true}});
  }

  static constexpr double U = 1.1;
  FilmCase contact = circular_contact();
  std::shared_ptr<const std::array<Topography, 2>> flanks;
};

GridShape inner(int nx) { return rectangle(nx, 9, -0.6, 0.6, 0.4); }

// Waves of flanks that roll keep their height in any number of nodes: nothing is missing that had to be added.
TEST(CarriedHeights, of_flanks_that_roll_need_no_transport) {
  const WavyContact rolling(Incompressible{});
  const CarriedHeights heights = rolling.at(Grid(PETSC_COMM_WORLD, inner(17)), 0.2, 0.0);
  const double largest = *std::ranges::max_element(heights.mass);
  EXPECT_GT(largest, 0.02);
  for (const double transport : heights.transport) EXPECT_NEAR(transport, 0.0, 1e-12 * largest);
}

// D q = dq/dT + d(U q)/dX by central differences, between flanks that slide and in oil that is compressed.
TEST(CarriedHeights, are_transported_with_their_flanks) {
  const WavyContact sliding(DowsonHigginson{});
  double before = 0.0;
  for (const int cells : {128, 256}) {
    const Grid grid(PETSC_COMM_WORLD, inner(cells + 1));
    const double step = grid.h_x(), S = 0.5;
    const CarriedHeights now = sliding.at(grid, 0.2, S), earlier = sliding.at(grid, 0.2 - step, S),
                         later = sliding.at(grid, 0.2 + step, S);
    const std::size_t rows = static_cast<std::size_t>(grid.y_count());
    double error = 0.0, size = 0.0;
    for (std::size_t n = rows; n + rows < now.mass.size(); ++n) {
      const double in_time = (later.mass[n] - earlier.mass[n]) / (2.0 * step),
                   along = WavyContact::U * (now.mass[n + rows] - now.mass[n - rows]) / (2.0 * step);
      error = std::max(error, std::abs(in_time + along - now.transport[n]));
      size = std::max(size, std::abs(now.transport[n]));
    }
    error = maximum(error) / maximum(size);
    if (before > 0.0) {
      EXPECT_LT(error, 0.02);
      EXPECT_NEAR(std::log2(before / error), 2.0, 0.1);
    }
    before = error;
  }
}

}  // namespace
}  // namespace gearfilm
