#include "gear/tooth_compliance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

double square(double x) { return x * x; }

/// Sainsot, Velex, Duverger 2004, doi 10.1115/1.1758252: A/theta^2 + B h^2 + C h/theta + D/theta + E h + F.
struct RingSeries {
  std::array<double, 6> c;

  double operator()(double theta, double h) const {
    return c[0] / (theta * theta) + c[1] * h * h + c[2] * h / theta + c[3] / theta + c[4] * h + c[5];
  }
};

constexpr RingSeries ring_L{{-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045}};
constexpr RingSeries ring_M{{60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086}};
constexpr RingSeries ring_P{{-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236}};
constexpr RingSeries ring_Q{{-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904}};

}  // namespace

GearCompliance::GearCompliance(const SpurGear& gear, const SpurGearPair& pair, ToothProfile profile,
                               FoundationModel foundation, const std::string& name)
    : profile_(std::move(profile)),
      plane_modulus_(gear.youngs_modulus / (1.0 - square(gear.poisson_ratio))),
      modulus_(gear.youngs_modulus),
      poisson_ratio_(gear.poisson_ratio),
      face_width_(pair.face_width),
      foundation_(foundation),
      bore_radius_(gear.bore_radius.value_or(0.0)) {
  const double root = profile_.root_radius();
  if (foundation == FoundationModel::sainsot) {
    if (bore_radius_ <= 0.0) {
      throw InputError(name + "_bore_radius is missing: gear_tooth_compliance sainsot is that of a ring; give it");
    }
    const double h = root / bore_radius_, theta = profile_.root_half_angle();
    if (h < 1.4 || h > 7.0 || theta < 0.01 || theta > 0.12) {
      throw InputError(name, "_bore_radius = ", bore_radius_, " m: the root circle is ", h,
                       " times as large, and half a tooth's angle at the root is ", theta,
                       "; gear_tooth_compliance sainsot is for 1.4 to 7 and 0.01 to 0.12: use weber");
    }
  }
  if (bore_radius_ <= 0.0) return;
  if (bore_radius_ >= root) {
    throw InputError(name, "_bore_radius = ", bore_radius_, " m is not below the root radius ", root, " m: reduce it");
  }
  const double E_b = modulus_ * face_width_;
  body_.torsion = (1.0 + poisson_ratio_) * square(profile_.base_radius()) / (2.0 * pi * E_b) *
                  (1.0 / square(bore_radius_) - 1.0 / square(root));
  // The half plane's logarithm; its factor 3 was fitted to finite elements.
  const double pitch = 2.0 * pi * root / gear.teeth;
  const auto coupling = [&](int pitches) {
    const double logarithm = std::log(3.0 * (root - bore_radius_) / (pitches * pitch));
    return body_.torsion + std::max(0.0, 2.0 * (1.0 - square(poisson_ratio_)) / (pi * E_b) * logarithm);
  };
  body_.neighbour = coupling(1);
  body_.neighbour2 = coupling(2);
}

ToothCompliance GearCompliance::tooth(double rho) const {
  const ToothLoad load = profile_.load_at(rho);
  const double cosine = std::cos(load.angle), sine = std::sin(load.angle);
  const double shear_modulus = modulus_ / (2.0 * (1.0 + poisson_ratio_));
  const std::vector<OutlinePoint> outline = profile_.outline_to(rho);
  ToothCompliance result;
  for (std::size_t n = 0; n + 1 < outline.size(); ++n) {
    const double dy = outline[n + 1].y - outline[n].y;
    const double y = 0.5 * (outline[n].y + outline[n + 1].y), x = 0.5 * (outline[n].x + outline[n + 1].x);
    const double area = 2.0 * x * face_width_, inertia = face_width_ * 8.0 * x * x * x / 12.0;
    result.bending += square(cosine * (load.y_axis - y)) / (plane_modulus_ * inertia) * dy;
    result.shear += 1.2 * square(cosine) / (shear_modulus * area) * dy;
    result.axial += square(sine) / (plane_modulus_ * area) * dy;
  }
  result.foundation = foundation_ == FoundationModel::weber ? weber(load) : sainsot(load);
  return result;
}

// Weber and Banaschek 1953, as Cornell 1981 (doi 10.1115/1.3254939) has it for any Poisson's ratio.
double GearCompliance::weber(const ToothLoad& load) const {
  const double root = profile_.root_radius(), theta = profile_.root_half_angle(), nu = poisson_ratio_;
  const double q = (load.y_axis - root * std::cos(theta)) / (2.0 * root * std::sin(theta));
  return square(std::cos(load.angle)) / (plane_modulus_ * face_width_) *
         (18.0 / pi * q * q + 2.0 * (1.0 - 2.0 * nu) / (1.0 - nu) * q +
          4.8 / pi * (1.0 + (1.0 - nu) / 2.4 * square(std::tan(load.angle))));
}

double GearCompliance::sainsot(const ToothLoad& load) const {
  const double root = profile_.root_radius(), theta = profile_.root_half_angle(), h = root / bore_radius_;
  const double q = (load.y_axis - root) / (2.0 * root * theta);
  return square(std::cos(load.angle)) / (modulus_ * face_width_) *
         (ring_L(theta, h) * q * q + ring_M(theta, h) * q +
          ring_P(theta, h) * (1.0 + ring_Q(theta, h) * square(std::tan(load.angle))));
}

}  // namespace gearfilm
