#include "lubricant/shear_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lubricant/independent_iterations.hpp"
#include "lubricant/vector_math.hpp"

namespace gearfilm {
namespace {

constexpr double unsheared = -300.0;  // ln of a stress that counts as none

// Without branches, so that loops over many places use vector instructions.

/// ln(sinh S/S), S of either sign.
[[gnu::always_inline]] inline double log_sinhc(double S) {
  const double s = std::max(std::abs(S), 1e-200), square = s * s;
  const double whole = s + log(expm1(-2.0 * s) / (-2.0 * s));
  return s < 1e-3 ? square * (1.0 / 6.0 - square / 180.0) : whole;
}

/// asinh(e^A) and its derivative.
[[gnu::always_inline]] inline MeanShear asinh_of_exp(double A) {
  const double e = exp(-std::abs(A)), root = std::sqrt(1.0 + e * e);
  return {std::max(A, 0.0) + log1p(A > 0.0 ? root : e + e * e / (1.0 + root)), (A > 0.0 ? 1.0 : e) / root};
}

[[gnu::always_inline]] inline MeanShear eyring_shear(double tau_0, double log_newtonian, double half_gradient) {
  const MeanShear relative = asinh_of_exp(log_newtonian - log(tau_0) - log_sinhc(half_gradient / tau_0));
  return {tau_0 * relative.stress, tau_0 * relative.by_rate};
}

/// ln g of Carreau's law and d ln g/d ln tau, of a stress given as ln(tau/G); ln g is relative to G too.
MeanShear log_carreau(const ShearLaw& law, double log_stress) {
  const double power = 1.0 / law.carreau_exponent - 1.0;
  // ln sqrt(1 + t^2) without overflow.
  const double larger = std::max(log_stress, 0.0), t = std::exp(-2.0 * std::abs(log_stress));
  const double log_root = larger + 0.5 * std::log1p(t);
  const double share = 1.0 / (1.0 + std::exp(-2.0 * log_stress));  // t^2/(1 + t^2)
  return {log_stress + power * log_root, 1.0 + power * share};
}

/// Mean of g over the film and its derivative by tau_m, in units of G: with t from b = tau_m - |S| to a = tau_m + |S|,
/// Int t (1+t^2)^(q-1) dt = [(1+a^2)^q - (1+b^2)^q]/(2 q), and a^2 - b^2 = 4 tau_m |S|.
MeanShear carreau_mean(const ShearLaw& law, double mean, double gradient) {
  const double q = 0.5 * (1.0 / law.carreau_exponent + 1.0);
  const double a = mean + gradient, b = mean - gradient, low = 1.0 + b * b;
  const double integral = std::pow(low, q) * std::expm1(q * std::log1p(4.0 * mean * gradient / low)) / (2.0 * q);
  const double slope = a * std::pow(1.0 + a * a, q - 1.0) - b * std::pow(low, q - 1.0);
  return {integral / (2.0 * gradient), slope / (2.0 * gradient)};
}

/// tau_m/G of Carreau's law.
MeanShear carreau_shear(const ShearLaw& law, double log_newtonian, double half_gradient) {
  const double wanted = log_newtonian - std::log(law.carreau_modulus),
               S = std::abs(half_gradient) / law.carreau_modulus;
  // Without gradient, which the law's two asymptotes enclose: their smaller one lies above.
  double log_stress = std::min(wanted, law.carreau_exponent * wanted);
  for (int n = 0; n < 60; ++n) {
    const MeanShear log_g = log_carreau(law, log_stress);
    const double change = (wanted - log_g.stress) / log_g.by_rate;
    log_stress += change;
    if (std::abs(change) < 1e-14 * (1.0 + std::abs(log_stress))) break;
  }
  const double alone = std::exp(log_stress);
  if (S < 1e-6 * (1.0 + alone)) return {alone, alone / log_carreau(law, log_stress).by_rate};
  // The mean of g over the film grows with tau_m from zero, and with the gradient: the answer lies below.
  const double rate = std::exp(wanted);
  double mean = alone, low = 0.0, high = alone;
  MeanShear now = carreau_mean(law, mean, S);
  for (int n = 0; n < 200; ++n) {
    (now.stress > rate ? high : low) = mean;
    const double newton =
        std::exp(std::log(mean) + (std::log(rate) - std::log(now.stress)) * now.stress / (mean * now.by_rate));
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    const double change = next - mean;
    mean = next;
    now = carreau_mean(law, mean, S);
    if (std::abs(change) < 1e-14 * mean) break;
  }
  return {mean, rate / now.by_rate};
}

[[gnu::always_inline]] inline MeanShear limited(const MeanShear& free, double limit) {
  return {free.stress < limit ? free.stress : limit, free.stress < limit ? free.by_rate : 0.0};
}

MeanShear unlimited(const ShearLaw& law, double log_newtonian, double half_gradient, double pressure) {
  switch (law.kind) {
    case ShearLawKind::newtonian: {
      const double stress = std::exp(log_newtonian);
      return {stress, stress};
    }
    case ShearLawKind::eyring:
      return eyring_shear(law.eyring_stress, log_newtonian, half_gradient);
    case ShearLawKind::carreau: {
      const MeanShear relative = carreau_shear(law, log_newtonian, half_gradient);
      return {law.carreau_modulus * relative.stress, law.carreau_modulus * relative.by_rate};
    }
    case ShearLawKind::coulomb:
      break;
  }
  return {law.coefficient * pressure, 0.0};
}

/// ln 3 (s cosh s - sinh s)/s^3, s >= 0.
double log_pressure_thinning(double s) {
  if (s < 0.05) return std::log1p(s * s / 10.0 + s * s * s * s / 280.0);
  return s + std::log(1.5 * ((s - 1.0) + (s + 1.0) * std::exp(-2.0 * s))) - 3.0 * std::log(s);
}

// Gauss and Legendre on [-1, 1]: abscissas above zero, weights.
constexpr std::array<double, 8> gauss_places = {0.0950125098376374402, 0.2816035507792589132, 0.4580167776572273863,
                                                0.6178762444026437484, 0.7554044083550030339, 0.8656312023878317439,
                                                0.9445750230732325761, 0.9894009349916499326};
constexpr std::array<double, 8> gauss_weights = {0.1894506104550684963, 0.1826034150449235889, 0.1691565193950025382,
                                                 0.1495959888165767321, 0.1246289712555338720, 0.0951585116824927848,
                                                 0.0622535239386478929, 0.0271524594117540949};

/// ln[g(tau)/tau].
double log_fluidity_ratio(const ShearLaw& law, double stress) {
  if (law.kind == ShearLawKind::eyring) return log_sinhc(stress / law.eyring_stress);
  const double t = stress / law.carreau_modulus;
  return 0.5 * (1.0 / law.carreau_exponent - 1.0) * std::log1p(t * t);
}

/// ln of 3/2 Int zeta^2 g/tau d zeta over [-1, 1].
double log_thinning_across(const ShearLaw& law, double stress, double gradient) {
  if (gradient < 1e-5 * stress || gradient == 0.0) return log_fluidity_ratio(law, stress);
  const double largest = log_fluidity_ratio(law, stress + gradient);
  double sum = 0.0;
  for (std::size_t k = 0; k < gauss_places.size(); ++k) {
    const double z = gauss_places[k];
    sum += gauss_weights[k] * z * z *
           (std::exp(log_fluidity_ratio(law, stress + z * gradient) - largest) +
            std::exp(log_fluidity_ratio(law, stress - z * gradient) - largest));
  }
  return largest + std::log(1.5 * sum);
}

/// ln of 3/(2 S) Int zeta g d zeta over [-1, 1], of Carreau's law.
double log_carreau_along(const ShearLaw& law, double stress, double gradient) {
  const double G = law.carreau_modulus, power = 1.0 / law.carreau_exponent - 1.0;
  if (gradient < 1e-5 * (G + stress)) {  // g'
    const double t2 = stress * stress / (G * G);
    return std::log1p(power * t2 / (1.0 + t2)) + 0.5 * power * std::log1p(t2);
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < gauss_places.size(); ++k) {
    const double z = gauss_places[k];
    sum += gauss_weights[k] * z * (fluidity(law, stress + z * gradient) - fluidity(law, stress - z * gradient));
  }
  return std::log(1.5 * sum / gradient);
}

}  // namespace

ShearThinning shear_thinning(const ShearLaw& law, double log_newtonian, double half_gradient) {
  log_newtonian = std::max(log_newtonian, unsheared);
  const double gradient = std::abs(half_gradient);
  const double stress = unlimited(law, log_newtonian, half_gradient, 0.0).stress;
  switch (law.kind) {
    case ShearLawKind::eyring: {
      const double s = gradient / law.eyring_stress;
      const double log_rate = log_newtonian - std::log(law.eyring_stress) - log_sinhc(s);
      const double log_root = std::max(log_rate, 0.0) + 0.5 * std::log1p(std::exp(-2.0 * std::abs(log_rate)));
      return {log_pressure_thinning(s) + log_root, log_thinning_across(law, stress, gradient)};
    }
    case ShearLawKind::carreau:
      return {log_carreau_along(law, stress, gradient), log_thinning_across(law, stress, gradient)};
    case ShearLawKind::newtonian:
    case ShearLawKind::coulomb:
      break;
  }
  return {};
}

double thinning_power(const ShearLaw& law) {
  return law.kind == ShearLawKind::carreau ? 1.0 - law.carreau_exponent : 1.0;
}

double ShearLaw::limit(double pressure) const {
  const bool none = kind == ShearLawKind::coulomb || limiting_ratio == 0.0;
  return none ? std::numeric_limits<double>::infinity() : std::max(limiting_stress, limiting_ratio * pressure);
}

MeanShear mean_shear(const ShearLaw& law, double log_newtonian, double half_gradient, double pressure) {
  return limited(unlimited(law, log_newtonian, half_gradient, pressure), law.limit(pressure));
}

void mean_shears(const ShearLaw& law, const ShearedPlaces& at, double* stress, double* by_rate) {
  // By value: what is stored might else be taken for a part of them.
  const auto each_place = [law, at, stress, by_rate](auto shear) {
    GEARFILM_INDEPENDENT_ITERATIONS
    for (std::size_t n = 0; n < at.count; ++n) {
      const MeanShear found =
          limited(shear(at.log_newtonian[n], at.half_gradient[n], at.pressure[n]), law.limit(at.pressure[n]));
      stress[n] = found.stress;
      by_rate[n] = found.by_rate;
    }
  };
  if (law.kind == ShearLawKind::eyring) {
    each_place([tau_0 = law.eyring_stress](double log_newtonian, double half_gradient, double) {
      return eyring_shear(tau_0, log_newtonian, half_gradient);
    });
  } else {
    each_place([&law](double log_newtonian, double half_gradient, double pressure) {
      return unlimited(law, log_newtonian, half_gradient, pressure);
    });
  }
}

double fluidity(const ShearLaw& law, double stress) {
  if (law.kind == ShearLawKind::eyring) return law.eyring_stress * std::sinh(stress / law.eyring_stress);
  if (law.kind == ShearLawKind::carreau) {
    const double t = stress / law.carreau_modulus;
    return stress * std::pow(1.0 + t * t, 0.5 * (1.0 / law.carreau_exponent - 1.0));
  }
  return stress;
}

}  // namespace gearfilm
