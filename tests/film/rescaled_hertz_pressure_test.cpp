// Pressures of a contact whose ellipse has become smaller or larger.
#include "film/rescaled_hertz_pressure.hpp"

#include "film_case.hpp"
#include "film/contact_film.hpp"
#include "grid/integral.hpp"

namespace gearfilm {
namespace {

class SimilarPressure : public testing::Test {
protected:
  std::vector<double> hertz_under(double share) const {
    std::vector<double> pressure(grid_.local_size());
    hertz_pressure(grid_, pitch_.scales, contact_under(share), pressure);
    return pressure;
  }
  HertzContact contact_under(double share) const {
    return dry_contact(pitch_.scales, {}, share * pitch_.scales.static_force);
  }

  const FilmCase pitch_ = table3_pitch();
  const Grid grid_{PETSC_COMM_WORLD, pitch_.shape(129, 65)};
};

TEST_F(SimilarPressure, of_a_hertz_contact_is_that_of_another_load) {
  for (const double share : {0.5, 1.1}) {
    const std::vector<double> expected = hertz_under(share);
    const std::vector<double> found =
        rescaled_hertz_pressure(grid_, pitch_.scales, contact_under(1.0), std::cbrt(share), hertz_under(1.0));
    std::vector<double> error(found.size());
    for (std::size_t n = 0; n < found.size(); ++n) error[n] = std::abs(found[n] - expected[n]);
    // The root at the edge is not linear between two nodes.
    EXPECT_LT(integral(grid_, error), 0.02 * integral(grid_, expected)) << share;
  }
}

TEST_F(SimilarPressure, ratio_of_one_changes_nothing) {
  const std::vector<double> before = hertz_under(0.9);
  const std::vector<double> after = rescaled_hertz_pressure(grid_, pitch_.scales, contact_under(0.9), 1.0, before);
  for (std::size_t n = 0; n < before.size(); ++n) EXPECT_NEAR(after[n], before[n], 1e-12);
}

}  // namespace
}  // namespace gearfilm
