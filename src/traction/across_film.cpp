#include "gearfilm/traction/across_film.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/error.hpp"
#include "gearfilm/lubricant/independent_iterations.hpp"

namespace gearfilm {
namespace {

// Of the last change of a temperature [K].
constexpr double tolerance = 1e-6;
constexpr double largest_step = 25.0;  // of Newton's method [K]
constexpr int most_iterations = 240;   // the last ones resisted
// Where a band of shear is as narrow as the points are apart, Newton's method may throw it from one to the next for
// ever: so many iterations in turn are Newton's, and resisted.
constexpr int patience = 20;
constexpr int profile_iterations = 3;  // after which u(z) stays as it is

template <class Operation>
inline void each_lane(Operation operation) {
  GEARFILM_INDEPENDENT_ITERATIONS
  for (int l = 0; l < AcrossFilm::lanes; ++l) operation(l);
}

}  // namespace

AcrossFilm::AcrossFilm(const ShearLaw& law, const Lubricant& oil, const HeatOptions& heat,
                       const SurfaceVelocities& velocities, const std::array<double, 2>& conductances)
    : upstream(heat.points),
      law_(law),
      viscosity_law_(oil.viscosity_law),
      viscosity_(oil, heat.oil),
      log_ambient_(std::log(oil.viscosity)),
      velocities_(velocities),
      conductances_(conductances),
      weights_(heat.points, 1.0 / (heat.points - 1)) {
  weights_.front() *= 0.5;
  weights_.back() *= 0.5;
  double second_moment = 0.0;
  for (int k = 0; k < points(); ++k) {
    places_.push_back(static_cast<double>(k) / (points() - 1));
    second_moment += weights_[k] * (places_[k] - 0.5) * (places_[k] - 0.5);
  }
  // The mean of Phi is p_x^2 h^2/(12 eta) on any points.
  for (const double place : places_) bent_.push_back((place - 0.5) * (place - 0.5) / (12.0 * second_moment));
  for (auto* field : {&T_, &transport_, &fluidity_, &slope_, &share_, &diagonal_, &right_, &bordered_}) {
    field->assign(points(), Lanes{});
  }
}

/// Viscosity, its shares across the film, and the mean stress, at the present temperatures.
template <ViscosityLaw law>
void AcrossFilm::shear() {
  const int count = points();
  Lanes mean{};
  for (int k = 0; k < count; ++k) {
    const double weight = weights_[k];
    each_lane([&](int l) {
      const TemperatureFunction eta = viscosity_.log_viscosity<law>(log_viscosity[l], T_[k][l]);
      fluidity_[k][l] = exp(-eta.value);
      slope_[k][l] = eta.derivative;
      mean[l] += weight * fluidity_[k][l];
    });
  }
  for (int k = 0; k < count; ++k) {
    each_lane([&](int l) { share_[k][l] = wet[l] * fluidity_[k][l] / mean[l] + (1.0 - wet[l]); });
  }
  const double sliding = std::abs(velocities_.sliding);
  for (int l = 0; l < lanes; ++l) {
    stress_[l] = by_rate_[l] = 0.0;
    if (wet[l] == 0.0 || sliding == 0.0) continue;
    const double log_newtonian = log_ambient_ + std::log(sliding / (thickness[l] * mean[l]));
    const MeanShear found = mean_shear(law_, log_newtonian, half_gradient[l], pressure[l]);
    stress_[l] = found.stress;
    by_rate_[l] = found.by_rate;
  }
}

/// rho c u(z)/h_x.
void AcrossFilm::set_transport() {
  const int count = points();
  const SurfaceVelocities& u = velocities_;
  Lanes passed{}, mean{};
  for (int k = 0; k < count; ++k) {
    const double place = places_[k], weight = weights_[k], half = 0.5 / (count - 1);
    each_lane([&](int l) {
      if (k > 0) passed[l] += half * (share_[k - 1][l] + share_[k][l]);
      const double speed = u.wheel() + u.sliding * passed[l] + 6.0 * poiseuille_flow[l] * place * (1.0 - place);
      transport_[k][l] = speed > 0.0 ? speed : 0.0;
      mean[l] += weight * transport_[k][l];
    });
  }
  each_lane([&](int l) { mean[l] = flow[l] * carried[l] / mean[l]; });
  for (int k = 0; k < count; ++k) each_lane([&](int l) { transport_[k][l] *= mean[l]; });
}

/// One step of Newton's method, or of one in pseudo-time whose changes are resisted; its largest change.
double AcrossFilm::improve(double resistance) {
  const int count = points();
  const double sliding = std::abs(velocities_.sliding);
  Lanes coupling;
  each_lane([&](int l) { coupling[l] = conductivity[l] * (count - 1) / thickness[l]; });
  for (int k = 0; k < count; ++k) {
    const Lanes& below = T_[std::max(k - 1, 0)];
    const Lanes& above = T_[std::min(k + 1, count - 1)];
    const double weight = weights_[k], neighbours = k == 0 || k == count - 1 ? 1.0 : 2.0;
    each_lane([&](int l) {
      const double width = weight * thickness[l], T = T_[k][l];
      // Heat of sliding in the cell: tau_m u_s n w.
      const double heat = weight * sliding * stress_[l] * share_[k][l];
      right_[k][l] = heat + width * (bent_[k] * poiseuille_heat[l] - transport_[k][l] * (T - upstream[k][l])) +
                     coupling[l] * (below[l] - 2.0 * T + above[l]);
      diagonal_[k][l] = width * transport_[k][l] + (neighbours + resistance) * coupling[l] + heat * slope_[k][l];
      bordered_[k][l] = -weight * sliding * (stress_[l] + by_rate_[l]) * share_[k][l];
    });
  }
  each_lane([&](int l) {
    right_.front()[l] -= (T_.front()[l] - base_wheel[l]) * conductances_[1];
    diagonal_.front()[l] += conductances_[1];
    right_.back()[l] -= (T_.back()[l] - base_pinion[l]) * conductances_[0];
    diagonal_.back()[l] += conductances_[0];
  });
  // Gauss on the tridiagonal part, for both right sides.
  for (int k = 1; k < count; ++k) {
    each_lane([&](int l) {
      const double factor = coupling[l] / diagonal_[k - 1][l];
      diagonal_[k][l] -= factor * coupling[l];
      right_[k][l] += factor * right_[k - 1][l];
      bordered_[k][l] += factor * bordered_[k - 1][l];
    });
  }
  Lanes with_right{}, with_bordered{};  // b . y, b . z
  for (int k = count - 1; k >= 0; --k) {
    const double weight = weights_[k];
    each_lane([&](int l) {
      if (k < count - 1) {
        right_[k][l] += coupling[l] * right_[k + 1][l];
        bordered_[k][l] += coupling[l] * bordered_[k + 1][l];
      }
      right_[k][l] /= diagonal_[k][l];
      bordered_[k][l] /= diagonal_[k][l];
      const double b = weight * share_[k][l] * slope_[k][l];
      with_right[l] += b * right_[k][l];
      with_bordered[l] += b * bordered_[k][l];
    });
  }
  Lanes factor, kept;
  Lanes& largest = change_;
  largest.fill(0.0);
  each_lane([&](int l) { factor[l] = with_right[l] / (1.0 + with_bordered[l]); });
  for (int k = 0; k < count; ++k) {
    each_lane([&](int l) {
      right_[k][l] -= factor[l] * bordered_[k][l];
      const double size = std::abs(right_[k][l]);
      largest[l] = largest[l] > size ? largest[l] : size;
    });
  }
  // A change keeps its direction: limited point by point, it may lead round in a circle.
  each_lane([&](int l) { kept[l] = largest[l] > largest_step ? largest_step / largest[l] : 1.0; });
  for (int k = 0; k < count; ++k) each_lane([&](int l) { T_[k][l] += kept[l] * right_[k][l]; });
  // Not a number is larger than anything.
  double worst = 0.0;
  for (const double size : largest) worst = size <= worst ? worst : size;
  return worst;
}

void AcrossFilm::solve() {
  const bool any_wet = std::ranges::any_of(wet, [](double value) { return value != 0.0; });
  T_ = upstream;
  if (!any_wet) {  // heat without a source: the equations are linear
    for (Lanes& share : share_) share.fill(1.0);
    stress_.fill(0.0);
    by_rate_.fill(0.0);
  }
  for (int n = 0; n < most_iterations; ++n) {
    if (any_wet && viscosity_law_ == ViscosityLaw::barus) shear<ViscosityLaw::barus>();
    if (any_wet && viscosity_law_ == ViscosityLaw::roelands) shear<ViscosityLaw::roelands>();
    if (n < profile_iterations) set_transport();
    const int phase = n / patience;
    const bool resisted = phase % 2 != 0;
    if (improve(resisted ? 0.5 * (phase + 1) : 0.0) < tolerance && !resisted) return;
  }
  for (int l = 0; l < lanes; ++l) {
    if (!std::isfinite(change_[l])) {
      throw SolveError("the temperature across the film was not found");
    }
  }
}

bool AcrossFilm::missed(int lane) const { return !(change_[lane] < tolerance); }

double AcrossFilm::heat_generated(int lane) const {
  double sum = stress_[lane] * std::abs(velocities_.sliding);
  for (int k = 0; k < points(); ++k) sum += weights_[k] * thickness[lane] * bent_[k] * poiseuille_heat[lane];
  return sum;
}

double AcrossFilm::heat_carried(int lane) const {
  double sum = 0.0;
  for (int k = 0; k < points(); ++k) {
    sum += weights_[k] * thickness[lane] * transport_[k][lane] * (T_[k][lane] - upstream[k][lane]);
  }
  return sum;
}

double AcrossFilm::mean_temperature(int lane) const {
  double sum = 0.0;
  for (int k = 0; k < points(); ++k) sum += weights_[k] * T_[k][lane];
  return sum;
}

}  // namespace gearfilm
