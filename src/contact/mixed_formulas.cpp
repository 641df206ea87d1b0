#include "contact/mixed_formulas.hpp"

#include <algorithm>
#include <cmath>

#include "contact/line_contact.hpp"

namespace gearfilm {
namespace {

constexpr double slowest = 1e-12;  // U

struct Groups {
  double W, U, G, s, V;
};

MixedPrediction of_line(const Groups& of, double R_x) {
  using std::pow;
  const auto& [W, U, G, s, V] = of;
  const double central = 2.691 * pow(W, -0.135) * pow(U, 0.705) * pow(G, 0.556) *
                         (1.0 + 0.2 * pow(s, 1.222) * pow(V, 0.223) * pow(W, -0.229) * pow(U, -0.748) * pow(G, -0.842));
  const double smallest =
      1.652 * pow(W, -0.077) * pow(U, 0.716) * pow(G, 0.695) *
      (1.0 + 0.026 * pow(s, 1.120) * pow(V, 0.185) * pow(W, -0.312) * pow(U, -0.809) * pow(G, -0.977));
  const double percent =
      0.005 * pow(W, -0.408) * pow(U, -0.088) * pow(G, 0.103) *
      std::log1p(4470.0 * pow(s, 6.015) * pow(V, 1.168) * pow(W, 0.485) * pow(U, -3.741) * pow(G, -2.898));
  return {central * R_x, smallest * R_x, 0.01 * percent, false};
}

MixedPrediction of_ellipse(const Groups& of, double k, double R_x) {
  using std::pow;
  const auto& [W, U, G, s, V] = of;
  const double central =
      3.672 * pow(W, -0.045 * pow(k, 0.18)) * pow(U, 0.663 * pow(k, 0.025)) * pow(G, 0.502 * pow(k, 0.064)) *
      (1.0 - 0.573 * std::exp(-0.74 * k)) *
      (1.0 + 0.025 * pow(s, 1.248) * pow(V, 0.119) * pow(W, -0.133) * pow(U, -0.884) * pow(G, -0.977) * pow(k, 0.081));
  const double smallest =
      1.637 * pow(W, -0.09 * pow(k, -0.15)) * pow(U, 0.711 * pow(k, -0.023)) * pow(G, 0.65 * pow(k, -0.045)) *
      (1.0 - 0.974 * std::exp(-0.676 * k)) *
      (1.0 + 0.141 * pow(s, 1.073) * pow(V, 0.149) * pow(W, -0.044) * pow(U, -0.828) * pow(G, -0.954) * pow(k, -0.395));
  const double percent = 10.0 * pow(W, -0.083) * pow(U, 0.143) * pow(G, 0.314) *
                         std::log1p(pow(s, 4.689) * pow(V, 0.509) * pow(W, -0.501) * pow(U, -2.9) * pow(G, -2.87));
  return {central * R_x, smallest * R_x, 0.01 * percent, false};
}

}  // namespace

MixedPrediction masjedi_khonsari(const ContactSolids& solids, const Lubricant& oil, const ContactOperation& operation) {
  const double R_x = solids.radius_x, stiffness = solids.reduced_modulus * R_x;
  const bool ellipse = has_ellipse(solids);
  const Groups groups{
      .W = ellipse ? operation.load / (stiffness * R_x) : load_per_length(solids, operation) / stiffness,
      .U = oil.viscosity * operation.entrainment_velocity / stiffness,
      .G = oil.pressure_viscosity * solids.reduced_modulus,
      .s = solids.rough->sigma() / R_x,
      .V = solids.rough->hardness() / solids.reduced_modulus};
  MixedPrediction found =
      ellipse ? of_ellipse(groups, 1.0 / hertz_ellipticity(R_x / solids.radius_y), R_x) : of_line(groups, R_x);
  found.valid = groups.U >= slowest && found.load_share <= 1.0;
  found.load_share = std::min(found.load_share, 1.0);
  return found;
}

}  // namespace gearfilm
