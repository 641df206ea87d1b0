// What a pair of gears is rated by.
#include "input/parameter_records.hpp"
#include "rating/rating_model.hpp"

namespace gearfilm {

std::vector<Parameter> rating_records() {
  const RatingLimits limits;
  const Range temperature = closed(200, 1000);
  return section(
      "rating", Scope::gear_pair,
      {optional("no safety", number("contact_limit", "sigma_Hlim", "Pa", left_open(1e7, 1e10),
                                    "allowable contact stress; of case-hardened steel 1.5e9 is usual")),
       optional("no safety", number("root_limit", "sigma_FE", "Pa", left_open(1e7, 1e10),
                                    "allowable stress at the root of unnotched teeth; 1e9 is usual")),
       preset(limits.cycles, number("cycles", "N_L", "-", closed(1, 1e12), "load cycles of the pinion's teeth")),
       optional("Z_L is 1", number("viscosity_40", "nu_40", "m^2/s", closed(1e-7, 1e-1),
                                   "kinematic viscosity of the oil at 40 degrees Celsius")),
       optional("Z_R is 1", number("roughness_depth", "R_z", "m", closed(1e-8, 1e-3),
                                   "peak-to-valley roughness, mean of both flanks")),
       optional("no safety",
                number("scuffing_temperature", "T_S", "K", temperature, "contact temperature at which the oil scuffs")),
       optional("no safety", number("integral_scuffing_temperature", "T_Sint", "K", temperature,
                                    "integral temperature at which the oil scuffs")),
       optional("thermal.temperature",
                number("oil_temperature", "T_oil", "K", temperature, "oil before it reaches the mesh")),
       optional("no safety", number("permissible_lambda", "lambda_GFP", "-", left_open(0, 10),
                                    "film ratio from which on flanks do not micropit, from a test of the oil"))});
}

}  // namespace gearfilm
