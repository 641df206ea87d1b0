// Conservation of mass by an accepted time step, from the flow through the faces of its nodes.
#include "accepted_steps.hpp"

namespace gearfilm {
namespace {

/// A field of both halves of the domain, whole, index i*ny + row.
std::vector<double> unfolded(const Grid& grid, const std::vector<double>& half) {
  std::vector<double> both;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int row = 1 - grid.rows(); row < grid.rows(); ++row) both.push_back(half[i * grid.rows() + std::abs(row)]);
  }
  return both;
}

/// Mass of one contact through the faces of its nodes, in whole arrays; rho H^3/(eta lambda) anew from pressure and
/// film.
class FaceFluxes {
public:
  FaceFluxes(const RecordedMarch& march, const ContactFilm& film)
      : grid_(march.grid()),
        U_(film.conditions().entrainment),
        pressure_(unfolded(grid_, whole_of(grid_, film.total_pressure()))) {
    const Scales& scales = march.problem().scales;
    const std::vector<double> heights = unfolded(grid_, whole_of(grid_, film.thickness()));
    for (std::size_t n = 0; n < heights.size(); ++n) {
      const double p = scales.pressure * pressure_[n], rho = relative_density(scales.oil, p).value;
      density_.push_back(rho);
      mass_.push_back(rho * heights[n]);
      fluidity_.push_back(std::exp(-log_relative_viscosity(scales.oil, p).value) / scales.lambda);
    }
    height_ = heights;
    carrying_ = 0.2 * grid_.h_x() * grid_.h_x() * 2.0 * std::numbers::pi * scales.C_h * U_;
  }

  int index(int i, int row) const { return i * grid_.ny() + row; }

  /// Through the face between nodes i and i+1: rho H at the face is between its extrapolation from upwind and the
  /// parabola through three nodes; in the first row it has its mean there.
  double along_x(int i, int row) const {
    const int n = index(i, row), east = index(i + 1, row), west = index(std::max(i - 1, 0), row);
    const double height =
        i == 0 ? 0.5 * (height_[n] + height_[east]) : 0.375 * height_[east] + 0.75 * height_[n] - 0.125 * height_[west];
    const double xi = conductance(n, east, height), part = xi / (xi + carrying_);
    const double parabola = 0.375 * mass_[east] + 0.75 * mass_[n] - 0.125 * mass_[west];
    const double upwind = 1.5 * mass_[n] - 0.5 * mass_[west];
    const double carried = i == 0 ? 0.5 * (mass_[n] + mass_[east]) : part * parabola + (1.0 - part) * upwind;
    return grid_.h_y() * (U_ * carried - xi * (pressure_[east] - pressure_[n]) / grid_.h_x());
  }
  /// Through the face between rows row and row+1.
  double along_y(int i, int row) const {
    const int n = index(i, row), north = index(i, row + 1);
    const double xi = conductance(n, north, 0.5 * (height_[n] + height_[north]));
    return -grid_.h_x() * xi * (pressure_[north] - pressure_[n]) / grid_.h_y();
  }

private:
  double conductance(int n, int next, double height) const {
    const double ratio = fluidity_[next] / fluidity_[n];
    const double fluidity = std::abs(ratio - 1.0) < 1e-7 ? 0.5 * (fluidity_[n] + fluidity_[next])
                                                         : (fluidity_[next] - fluidity_[n]) / std::log(ratio);
    return 0.5 * (density_[n] + density_[next]) * std::pow(height, 3) * fluidity;
  }

  const Grid& grid_;
  double U_, carrying_ = 0.0;
  std::vector<double> pressure_, height_, density_, mass_, fluidity_;
};

/// What passes the border of the full nodes.
struct BorderFlow {
  double in = 0.0;
  double out = 0.0;

  void add(double outward) { (outward > 0.0 ? out : in) += std::abs(outward); }
};

BorderFlow border_flow(const Grid& grid, const FaceFluxes& fluxes, const std::vector<double>& full_film) {
  const auto is_full = [&](int i, int row) { return full_film[fluxes.index(i, row)] != 0.0; };
  BorderFlow flow;
  for (int i = 0; i + 1 < grid.nx(); ++i) {
    for (int row = 0; row + 1 < grid.ny(); ++row) {
      if (is_full(i, row) != is_full(i + 1, row)) flow.add((is_full(i, row) ? 1.0 : -1.0) * fluxes.along_x(i, row));
      if (is_full(i, row) != is_full(i, row + 1)) flow.add((is_full(i, row) ? 1.0 : -1.0) * fluxes.along_y(i, row));
    }
  }
  return flow;
}

// The discrete equations of all full nodes telescope: what flows in through the border of the full set flows out or is
// stored. The cavitated nodes, where the film is not full, are outside.
TEST(MassBalance, mass_is_conserved_over_a_step) {
  const CaseInput problem =
      table3_case(with(after_leaving(), {{"time.newton_tolerance", "1e-9"}, {"film.discretisation", "fitted"}}));
  const AcceptedSteps steps(problem, 0.5);
  ASSERT_NEAR(steps.last.dT, steps.last_but_one.dT, 1e-12);
  const Grid& grid = steps.march.grid();
  PairAt system(steps.march, steps.last);
  const OwnedVec state = system.vector(steps.last.pressure, steps.last.motion);
  // The full nodes are those of the residual with its rate.
  OwnedVec rate = system.vector(steps.last.mass, steps.last.motion), rows = system.system().create_state();
  petsc_check(VecScale(rate, 1.5 / steps.last.dT));
  petsc_check(VecAXPY(rate, -2.0 / steps.last.dT, system.vector(steps.last_but_one.mass, steps.last_but_one.motion)));
  petsc_check(VecAXPY(rate, 0.5 / steps.last.dT, system.vector(steps.before_last.mass, steps.before_last.motion)));
  system.system().residual(state, {rate, 1.5 / steps.last.dT}, rows);
  const ContactFilm& film = system.film(0);
  const FaceFluxes fluxes(steps.march, film);
  const std::vector<double> full_film = unfolded(grid, whole_of(grid, film.state().full_film)),
                            rates = unfolded(grid, whole_of(grid, system.system().field(rate, 0)));
  double stored = 0.0;
  int full_nodes = 0;
  for (std::size_t n = 0; n < full_film.size(); ++n) {
    if (full_film[n] == 0.0) continue;
    stored += grid.h_x() * grid.h_y() * rates[n];
    ++full_nodes;
  }
  const BorderFlow flow = border_flow(grid, fluxes, full_film);
  report("inflow %.6f, outflow %.6f, storage %.6f, balance %.2e", flow.in, flow.out, stored,
         flow.in - flow.out - stored);
  // Both must matter against what the balance may miss.
  EXPECT_GT(flow.out, 1.0);
  EXPECT_GT(std::abs(stored), 0.01);
  EXPECT_LT(full_nodes, (grid.nx() - 2) * (grid.ny() - 2));  // some nodes are cavitated
  // A sum of n rows is at most sqrt(n) times their norm, which Newton's tolerance bounds.
  const double bound = grid.h_x() * grid.h_y() * std::sqrt(full_nodes) * system.system().weight() *
                       problem.numerics.steps.newton.tolerance;
  EXPECT_NEAR(flow.in - flow.out, stored, bound + 1e-11 * flow.in);
}

}  // namespace
}  // namespace gearfilm
