#include "input/case_checks.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

// Hertz's theory is for small strains, which are of the order of p_h/E'; p_h grows with the cube root of the load.
void check_strain(const Scales& scales, double load_ratio, const std::string& name) {
  constexpr double largest = 0.1;
  const double pressure = std::cbrt(load_ratio) * scales.hertz.pressure;
  const double strain = pressure / scales.solids.reduced_modulus;
  if (strain <= largest) return;
  throw InputError("the Hertz pressure is ", pressure * 1e-9, " GPa, ", strain,
                   " of the reduced modulus: no elastic contact carries it; lower ", name, " of ",
                   load_ratio * scales.operation.load,
                   " N (torque in N m, forces in N, lengths in m), or raise the moduli or radii");
}

// A displacement at the start beyond what a contact with such a pressure has: p_h grows with the root of the approach.
void check_start_motion(const CaseInput& result) {
  if (!result.march.start_motion) return;
  const double depth = -result.march.start_motion->H0() / result.scales.approach;
  if (depth <= 1.0) return;
  check_strain(result.scales, std::pow(depth, 1.5), "-start_H0, which stands for a force");
}

// Teeth that give way by a module are out of mesh.
void check_deflection(const CaseInput& result) {
  const double load = result.scales.operation.load, module_length = result.pair.gears->module_length;
  const double deflection = load * result.pair.teeth.compliance(0.0);
  if (deflection < module_length) return;
  throw InputError("the teeth would give way by ", deflection, " m under the static force of ", load,
                   " N, more than the module of ", module_length,
                   " m: lower gear.mesh_compliance, gear.compliance_factor or the table's values, which are in m/N");
}

}  // namespace

void check_strain(const CaseInput& problem) { check_strain(problem.scales, 1.0, "the load"); }

void check_loads(const CaseInput& problem) {
  check_strain(problem.scales, problem.steady.load_ratio, "steady.load_ratio with a load");
  if (problem.kind != CaseKind::gear_pair) return;
  check_strain(problem.scales, std::ranges::max(problem.statics.load_ratios), "static.load_ratios with a load");
  check_deflection(problem);
  check_start_motion(problem);
}

}  // namespace gearfilm
