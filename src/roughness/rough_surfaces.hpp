// Two rough surfaces as their lubricated contact sees them: statistics of their heights, and what follows from them.
#pragma once

#include <array>
#include <cstdint>

#include "roughness/asperity_law.hpp"
#include "roughness/gap_table.hpp"
#include "roughness/rough_flow.hpp"

namespace gearfilm {

/// What the oil between rough surfaces fills.
enum class MeanGap : std::uint8_t {
  gaussian,  ///< the mean of the gaps that are open, of Gaussian heights
  nominal    ///< the gap of the mean planes, which may be negative
};

struct RoughOptions {
  std::array<double, 2> roughness{};    ///< Rq of both flanks [m]
  std::array<double, 2> lay{1.0, 1.0};  ///< gamma of both, 0.11 to 9
  AsperityOptions asperities{};
  MeanGap mean_gap = MeanGap::gaussian;
};

class RoughSurfaces {
public:
  RoughSurfaces(const RoughOptions& options, double reduced_modulus);

  double sigma() const { return sigma_; }  ///< [m]
  /// Of both flanks together: the mean of ln gamma, weighted by the squares of their roughness (an assumption).
  double lay() const { return lay_; }
  bool isotropic() const { return lay_ == 1.0; }
  /// Hardness of the softer surface [Pa].
  double hardness() const { return options_.asperities.hardness; }
  const AsperityLaw& asperities() const { return asperities_; }

  /// h_T/sigma.
  GapFunction mean_gap(double z) const {
    return options_.mean_gap == MeanGap::gaussian ? gaussian_mean_gap(z) : GapFunction{z, 1.0};
  }
  /// C^(1/3), along the entrainment and across it.
  GapFunction conducting_along(double z) const { return along_(z); }
  GapFunction conducting_across(double z) const { return across_(z); }
  /// phi_s of sliding u_1 - u_2.
  GapFunction shear_flow(double z) const;
  /// All of them, from the table; below it the functions themselves. From z = 12 on asperities carry nothing.
  GapValues at(double z) const { return z > GapTable::first && z < GapTable::last ? table_(z) : beyond_table(z); }
  bool has_shear_flow() const { return share_[0] != share_[1] || options_.lay[0] != options_.lay[1]; }

private:
  GapValues functions_at(double z) const;
  GapValues beyond_table(double z) const;  ///< on either side

  RoughOptions options_;
  double sigma_ = 0.0;
  std::array<double, 2> share_{};  ///< (Rq_i/sigma)^2
  double lay_ = 1.0;
  AsperityLaw asperities_;
  ConductingGap along_, across_;
  std::array<ShearFlow, 2> shear_;
  GapTable table_;
};

}  // namespace gearfilm
