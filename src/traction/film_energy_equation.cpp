#include "traction/film_energy_equation.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/error.hpp"
#include "numerics/tuned.hpp"
#include "traction/tridiagonal_lanes.hpp"

namespace gearfilm {
namespace {

// Of the last change of a temperature [K]. Newton's method squares what is left over the tens of kelvins over which oil
// changes: 1e-11 K. The viscosities are those before it, 1e-6 of them off.
const Tuned<double> tolerance("energy_tolerance", 2e-5, "last change of a temperature in Newton's method [K]");
const Tuned<double> largest_step("energy_largest_step", 25.0, "largest step of Newton's method [K]");
const Tuned<double> small_change("energy_small_change", 0.02,
                                 "change of a temperature after which viscosities follow by their slopes [K]");
const Tuned<int> most_iterations("energy_most_iterations", 240,
                                 "iterations for the temperatures across the film at most");
// Where a band of shear is as narrow as the points are apart, Newton's method may throw it from one to the next for
// ever: so many iterations are Newton's, then so many are damped, and so on.
const Tuned<int> patience("energy_patience", 20,
                          "iterations across the film that are Newton's at one time and damped at the next");
const Tuned<int> profile_iterations("energy_profile_iterations", 3,
                                    "iterations across the film after which the velocity profile stays as it is");

std::vector<double> trapezoidal_weights(int points) {
  std::vector<double> weights(points, 1.0 / (points - 1));
  weights.front() *= 0.5;
  weights.back() *= 0.5;
  return weights;
}

std::vector<double> evenly_spaced(int points) {
  std::vector<double> places(points);
  for (int k = 0; k < points; ++k) places[k] = static_cast<double>(k) / (points - 1);
  return places;
}

/// Coefficient of a neighbour's temperature, by conduction and by the flow that comes from it: centred where the one is
/// strong enough, else upwind.
inline double neighbour_coefficient(double conduction, double flow) {
  const double centred = conduction + 0.5 * flow, most = flow > 0.0 ? flow : 0.0;
  return centred > most ? centred : most;
}

}  // namespace

FilmEnergyEquation::FilmEnergyEquation(const ShearLaw& law, const Lubricant& oil, const HeatOptions& heat,
                                       FlowProfile kind)
    : upstream(heat.points),
      before(heat.points),
      earlier(heat.points),
      downstream(heat.points),
      arriving(heat.points),
      upstream_factor(heat.points),
      downstream_factor(heat.points),
      law_(law),
      viscosity_(viscosity_evaluator(oil, heat.oil)),
      log_ambient_(std::log(oil.viscosity)),
      flow_(kind),
      weights_(trapezoidal_weights(heat.points)),
      places_(evenly_spaced(heat.points)),
      own_(weights_, places_) {
  double second_moment = 0.0;
  for (int k = 0; k < points(); ++k) {
    second_moment += weights_[k] * (places_[k] - 0.5) * (places_[k] - 0.5);
  }
  // The mean of Phi is p_x^2 h^2/(12 eta) on any points.
  for (const double place : places_) bent_.push_back((place - 0.5) * (place - 0.5) / (12.0 * second_moment));
  for (auto* field : {&T_, &source_, &speed_, &transport_, &below_, &above_, &log_viscosities_, &fluidity_, &slope_,
                      &share_, &diagonal_, &right_, &bordered_, &second_}) {
    field->assign(points(), Lanes{});
  }
}

/// Viscosities at the present temperatures.
template <EvaluatesViscosity Viscosity>
void FilmEnergyEquation::find_viscosities(Viscosity viscosity) {
  for (int k = 0; k < points(); ++k) {
    each_lane([&](int l) {
      const TemperatureFunction eta = viscosity.log_viscosity(log_viscosity[l], pressure[l], T_[k][l]);
      log_viscosities_[k][l] = eta.value;
      fluidity_[k][l] = exp(-eta.value);
      slope_[k][l] = eta.derivative;
    });
  }
}

/// The same after a change so small that viscosities follow their slopes.
void FilmEnergyEquation::follow_viscosities() {
  for (int k = 0; k < points(); ++k) {
    each_lane([&](int l) {
      const double gain = slope_[k][l] * right_[k][l];
      log_viscosities_[k][l] += gain;
      fluidity_[k][l] *= 1.0 - gain * (1.0 - gain * (0.5 - gain * (1.0 / 6.0)));
    });
  }
}

/// Their shares across the film, and the mean stress.
void FilmEnergyEquation::shear() {
  const int count = points();
  Lanes mean{}, inverse;
  for (int k = 0; k < count; ++k) {
    const double weight = weights_[k];
    each_lane([&](int l) { mean[l] += weight * fluidity_[k][l]; });
  }
  Lanes sheared;
  each_lane([&](int l) {
    inverse[l] = full_film[l] / mean[l];
    sheared[l] = sliding[l] != 0.0 ? full_film[l] : 0.0;
    log_newtonian_[l] =
        log_ambient_ + log(sheared[l] != 0.0 ? std::abs(sliding[l]) / (thickness[l] * mean[l]) : no_shear_rate);
  });
  for (int k = 0; k < count; ++k) {
    each_lane([&](int l) { share_[k][l] = fluidity_[k][l] * inverse[l] + (1.0 - full_film[l]); });
  }
  mean_shears(law_, {lanes, log_newtonian_.data(), half_gradient.data(), pressure.data()}, stress_.data(),
              by_rate_.data());
  each_lane([&](int l) {
    stress_[l] = sheared[l] != 0.0 ? stress_[l] : 0.0;
    by_rate_[l] = sheared[l] != 0.0 ? by_rate_[l] : 0.0;
  });
}

void FilmEnergyEquation::set_transport() {
  const int count = points();
  Lanes passed{}, mean{}, conduction;
  for (int k = 0; k < count; ++k) {
    const double place = places_[k], weight = weights_[k], half = 0.5 / (count - 1);
    each_lane([&](int l) {
      if (k > 0) passed[l] += half * (share_[k - 1][l] + share_[k][l]);
      const double wheel = mean_velocity[l] - 0.5 * sliding[l];
      const double speed = wheel + sliding[l] * passed[l] + 6.0 * poiseuille_flow[l] * place * (1.0 - place);
      transport_[k][l] = speed > 0.0 ? speed : 0.0;
      mean[l] += weight * transport_[k][l];
    });
  }
  each_lane([&](int l) {
    mean[l] = flow[l] * carried[l] * thickness[l] / mean[l];
    conduction[l] = conductivity[l] * (count - 1) / thickness[l];
  });
  for (int k = 0; k < count; ++k) {
    const double weight = weights_[k], from_below = k > 0 ? 1.0 : 0.0, from_above = k < count - 1 ? 1.0 : 0.0;
    each_lane([&](int l) {
      transport_[k][l] *= weight * mean[l];
      below_[k][l] = from_below * conduction[l];
      above_[k][l] = from_above * conduction[l];
    });
  }
}

/// That of film_flow.hpp; of a cavitated film the part that fills it, between walls that shear it evenly.
void FilmEnergyEquation::set_own_transport() {
  const int count = points();
  Lanes passed{}, mean_change{}, flow_up{};
  for (int k = 0; k < count; ++k) {
    const double weight = weights_[k], half = 0.5 / (count - 1);
    each_lane([&](int l) {
      if (k > 0) passed[l] += half * (share_[k - 1][l] + share_[k][l]);
      const double filled = full_film[l] + (1.0 - full_film[l]) * flow[l] / mean_velocity[l];
      const double wheel = mean_velocity[l] - 0.5 * sliding[l];
      const double speed = filled * (wheel + sliding[l] * passed[l]) + own_.poiseuille[k][l];
      const double passing = thickness[l] * carried[l] * speed;
      speed_[k][l] = speed;
      source_[k][l] = speed < 0.0 ? downstream[k][l] : upstream[k][l];
      transport_[k][l] = weight * (speed < 0.0 ? -downstream_factor[k][l] * passing : upstream_factor[k][l] * passing);
      // For a moment: what stays behind, or is added.
      above_[k][l] = full_film[l] * (step_factor[l] * passing - arriving[k][l]);
      mean_change[l] += weight * above_[k][l];
    });
  }
  for (int k = 0; k < count; ++k) {
    const double weight = weights_[k], from_below = k > 0 ? 1.0 : 0.0, from_above = k < count - 1 ? 1.0 : 0.0;
    each_lane([&](int l) {
      const double conduction = conductivity[l] * (count - 1) / thickness[l];
      below_[k][l] = from_below * neighbour_coefficient(conduction, flow_up[l]);
      flow_up[l] -= weight * (above_[k][l] - mean_change[l]);
      above_[k][l] = from_above * neighbour_coefficient(conduction, -flow_up[l]);
    });
  }
}

/// Rows and matrix of Newton's method: what the cells get, its derivatives by their own temperatures, and the columns
/// of both parts of rank one.
template <bool own>
void FilmEnergyEquation::assemble(double resistance) {
  const int count = points();
  for (int k = 0; k < count; ++k) {
    const Lanes& below = T_[std::max(k - 1, 0)];
    const Lanes& above = T_[std::min(k + 1, count - 1)];
    const Lanes& source = own ? source_[k] : upstream[k];
    const double weight = weights_[k];
    each_lane([&](int l) {
      const double width = weight * thickness[l], T = T_[k][l];
      // Heat of sliding in the cell: tau_m u_s n w.
      const double heat = weight * std::abs(sliding[l]) * stress_[l] * share_[k][l];
      const double bulk = own ? own_.heat[k][l] : bent_[k] * poiseuille_heat[l];
      right_[k][l] = heat + width * bulk - transport_[k][l] * (T - source[l]) + below_[k][l] * (below[l] - T) +
                     above_[k][l] * (above[l] - T);
      diagonal_[k][l] =
          transport_[k][l] + (1.0 + 0.5 * resistance) * (below_[k][l] + above_[k][l]) + heat * slope_[k][l];
      bordered_[k][l] = -weight * std::abs(sliding[l]) * (stress_[l] + by_rate_[l]) * share_[k][l];
      if constexpr (own) {
        right_[k][l] -= width * stored[l] * (T - earlier[k][l]);
        diagonal_[k][l] += width * (stored[l] + own_.diagonal[k][l]);
        second_[k][l] = width * own_.column[k][l];
      }
    });
  }
  each_lane([&](int l) {
    right_.front()[l] -= (T_.front()[l] - base_wheel[l]) * conductance_wheel[l];
    diagonal_.front()[l] += conductance_wheel[l];
    right_.back()[l] -= (T_.back()[l] - base_pinion[l]) * conductance_pinion[l];
    diagonal_.back()[l] += conductance_pinion[l];
  });
}

/// Takes the parts of rank one off the solution: with b of tau_m and d of Phi,
/// (1 + b.B) (b.x) + (b.S) (d.x) = b.r and so on.
template <bool own>
void FilmEnergyEquation::correct() {
  const int count = points();
  Lanes b_right{}, b_bordered{}, b_second{}, d_right{}, d_bordered{}, d_second{};
  for (int k = 0; k < count; ++k) {
    const double weight = weights_[k];
    each_lane([&](int l) {
      const double b = weight * share_[k][l] * slope_[k][l];
      b_right[l] += b * right_[k][l];
      b_bordered[l] += b * bordered_[k][l];
      if constexpr (own) {
        const double d = own_.row[k][l];
        b_second[l] += b * second_[k][l];
        d_right[l] += d * right_[k][l];
        d_bordered[l] += d * bordered_[k][l];
        d_second[l] += d * second_[k][l];
      }
    });
  }
  each_lane([&](int l) {
    if constexpr (own) {
      const double determinant = (1.0 + b_bordered[l]) * (1.0 + d_second[l]) - b_second[l] * d_bordered[l];
      by_stress_[l] = (b_right[l] * (1.0 + d_second[l]) - b_second[l] * d_right[l]) / determinant;
      by_heat_[l] = (d_right[l] * (1.0 + b_bordered[l]) - d_bordered[l] * b_right[l]) / determinant;
    } else {
      by_stress_[l] = b_right[l] / (1.0 + b_bordered[l]);
    }
  });
  for (int k = 0; k < count; ++k) {
    each_lane([&](int l) {
      right_[k][l] -= by_stress_[l] * bordered_[k][l];
      if constexpr (own) right_[k][l] -= by_heat_[l] * second_[k][l];
    });
  }
}

/// One step of Newton's method, or of one in pseudo-time whose changes are resisted; its largest change.
template <bool own>
double FilmEnergyEquation::improve(double resistance) {
  assemble<own>(resistance);
  if constexpr (own) {
    solve_tridiagonal<3>(below_, above_, diagonal_, {&right_, &bordered_, &second_});
  } else {
    solve_tridiagonal<2>(below_, above_, diagonal_, {&right_, &bordered_});
  }
  correct<own>();
  change_.fill(0.0);
  for (const Lanes& step : right_) {
    each_lane([&](int l) {
      const double size = std::abs(step[l]);
      change_[l] = change_[l] > size ? change_[l] : size;
    });
  }
  // A change keeps its direction: limited point by point, it may lead round in a circle.
  Lanes kept;
  each_lane([&](int l) { kept[l] = change_[l] > largest_step ? largest_step / change_[l] : 1.0; });
  for (int k = 0; k < points(); ++k) each_lane([&](int l) { T_[k][l] += kept[l] * right_[k][l]; });
  // Not a number is larger than anything.
  double worst = 0.0;
  for (const double size : change_) worst = size <= worst ? worst : size;
  return worst;
}

/// What follows from the present temperatures.
void FilmEnergyEquation::update(bool sheared, int iteration) {
  const bool own = flow_ == FlowProfile::thermal;
  if (sheared) {
    if (iteration > 0 && std::ranges::all_of(change_, [](double change) { return change < small_change; })) {
      follow_viscosities();
    } else {
      std::visit([&](const auto& viscosity) { find_viscosities(viscosity); }, viscosity_);
    }
    shear();
  }
  if (own) {
    own_.update({fluidity_, slope_, log_viscosities_, share_},
                {full_film, thickness, log_viscosity, poiseuille_flow, driven_flow, stress_, shear_factor,
                 std::exp(log_ambient_), sliding});
    if (iteration == 0) set_own_transport();
  } else if (iteration < profile_iterations) {
    set_transport();
  }
}

void FilmEnergyEquation::solve() {
  const bool own = flow_ == FlowProfile::thermal;
  const bool sheared = own || std::ranges::any_of(full_film, [](double value) { return value != 0.0; });
  T_ = before;
  if (!sheared) {  // heat without a source: the equations are linear
    for (Lanes& share : share_) share.fill(1.0);
    stress_.fill(0.0);
    by_rate_.fill(0.0);
  }
  for (int n = 0; n < most_iterations; ++n) {
    update(sheared, n);
    const int phase = n / patience;
    const bool resisted = phase % 2 != 0;
    const double resistance = resisted ? 0.5 * (phase + 1) : 0.0;
    if ((own ? improve<true>(resistance) : improve<false>(resistance)) < tolerance && !resisted) break;
  }
  own ? take_stock<true>() : take_stock<false>();
  if (!std::ranges::all_of(change_, [](double change) { return std::isfinite(change); })) {
    throw SolveError("the temperature across the film was not found");
  }
}

bool FilmEnergyEquation::unconverged(int lane) const { return !(change_[lane] < tolerance); }

/// Means and sums of the solution. What the last change adds to stress and heat is that of the linear equations, so
/// that heat is balanced as these are solved.
template <bool own>
void FilmEnergyEquation::take_stock() {
  const int count = points();
  Lanes conduction, found;
  each_lane([&](int l) {
    conduction[l] = conductivity[l] * (count - 1) / thickness[l];
    found[l] = change_[l] < tolerance ? 1.0 : 0.0;
    by_stress_[l] *= found[l];
    by_heat_[l] *= found[l];
    stress_[l] += by_rate_[l] * by_stress_[l];
    heat_generated_[l] = stress_[l] * std::abs(sliding[l]);
    heat_carried_[l] = mean_temperature_[l] = largest_temperature_[l] = 0.0;
  });
  for (int k = 0; k < count; ++k) {
    const Lanes &below = T_[std::max(k - 1, 0)], &above = T_[std::min(k + 1, count - 1)];
    const Lanes& source = own ? source_[k] : upstream[k];
    const double weight = weights_[k];
    each_lane([&](int l) {
      const double T = T_[k][l], width = weight * thickness[l];
      mean_temperature_[l] += weight * T;
      largest_temperature_[l] = T > largest_temperature_[l] ? T : largest_temperature_[l];
      if constexpr (own) {
        heat_generated_[l] +=
            width * (own_.heat[k][l] - found[l] * own_.diagonal[k][l] * right_[k][l] - own_.column[k][l] * by_heat_[l]);
      } else {
        heat_generated_[l] += width * bent_[k] * poiseuille_heat[l];
      }
      heat_carried_[l] += transport_[k][l] * (T - source[l]);
      if constexpr (own) {
        heat_carried_[l] += width * stored[l] * (T - earlier[k][l]) + (below_[k][l] - conduction[l]) * (T - below[l]) +
                            (above_[k][l] - conduction[l]) * (T - above[l]);
      }
    });
  }
}

}  // namespace gearfilm
