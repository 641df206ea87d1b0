// The mean pressure with which asperities of two rough surfaces press on each other, by the gap of their mean planes.
//
//   p_a(z) ,  z = h/sigma ,  sigma^2 = Rq_1^2 + Rq_2^2                 [Pa]; z may be negative
// For the summits (density n, radius beta, Gaussian heights about a plane y_s above the mean one, sigma_s), with
// E* = E'/2, F_n of height_integrals.hpp, u = (z - y_s/sigma) sigma/sigma_s:
//   Greenwood, Tripp         (16 sqrt(2) pi/15) (n beta sigma_s)^2 sqrt(sigma_s/beta) E* F_5/2(u)
//   Greenwood, Williamson    (4/3) n beta sigma_s sqrt(sigma_s/beta) E* F_3/2(u)
//   Zhao, Maietta, Chang     n Int w(s - u) exp(-s^2/2)/sqrt(2 pi) ds, w the load of an asperity that is pressed in by
//       d: elastic, w = (4/3) E* beta^(1/2) d^(3/2), up to d_1 = (3 pi k H/(4 E*))^2 beta, k = 0.4; plastic,
//       2 pi beta d H, from d_2 = 54 d_1 on; between them the area pi beta d (1 - 2 t^3 + 3 t^2),
//       t = (d - d_1)/(d_2 - d_1), under the pressure H - H (1 - k) ln(d_2/d)/ln(d_2/d_1)
//   exponential              p_0 exp(-z/g)
// Summits lie higher than the surface: y_s/sigma = 0.045944/(n beta sigma),
// (sigma_s/sigma)^2 = 1 - 3.717e-4/(n beta sigma)^2; without the shift y_s = 0, sigma_s = sigma.
// Assumption: the constants of the third law and of the shift are from memory (Zhao, Maietta and Chang 2000, McCool);
// the load is continuous at d_1 and the two constants of the shift agree with each other.
// Part of the surface on which summits touch (none is known of the last law and of tables), by the areas of summits:
//   Greenwood, Tripp         (pi n beta sigma_s)^2 F_2(u)
//   Greenwood, Williamson    pi n beta sigma_s F_1(u)
//   Zhao, Maietta, Chang     n Int A(s - u) exp(-s^2/2)/sqrt(2 pi) ds, A = w over its mean pressure: pi beta d, elastic
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace gearfilm {

enum class AsperityLawKind : std::uint8_t {
  greenwood_tripp,
  greenwood_williamson,
  zhao_maietta_chang,
  exponential,
  table
};

struct AsperityOptions {
  AsperityLawKind kind = AsperityLawKind::zhao_maietta_chang;
  double density_product = 0.05;      ///< n beta sigma [-]
  double slope = 0.01;                ///< sigma/beta [-]
  double hardness = 7e9;              ///< H of the softer surface [Pa]
  bool summit_shift = true;           ///< summits lie higher than the surface
  double exponential_pressure = 1e9;  ///< p_0 [Pa]
  double exponential_gap = 0.48;      ///< g [-]
  std::vector<double> table_z{};      ///< increasing
  std::vector<double> table_p{};      ///< decreasing, > 0 [Pa]
};

/// A law with its slope: a spline of ln p_a over z, which goes on straight at both ends. So p_a is positive and falls
/// everywhere, and Newton's method needs no guard.
class AsperityLaw {
public:
  AsperityLaw(const AsperityOptions& options, double reduced_modulus);

  struct Value {
    double pressure;  ///< p_a [Pa]
    double slope;     ///< dp_a/dz [Pa], < 0
  };
  Value operator()(double z) const;
  /// The part of the surface on which summits touch at z, at most 1; nothing where the law says nothing of it.
  std::optional<double> real_area(double z) const;
  bool knows_real_area() const;
  /// The z at which asperities press so much, > 0 [Pa].
  double gap_under(double pressure) const;

private:
  double log_pressure(double z, double& slope) const;

  AsperityOptions options_;
  double modulus_;                     ///< E* [Pa]
  std::vector<double> value_, slope_;  ///< of ln p_a at equal distances
};

}  // namespace gearfilm
