// The gear pair without lubricant: Hertz contacts in place of films.
//
//   dH_0/dT = V_0 ,   I_n (dV_0/dT + c V_0) = sum_k F_k(H_0) - F* ,   F_k = Hertz force at R_x(xi_k), approach -h_0
// with c = 4 pi zeta f_n for a damper in the place of films. The start and the check of the lubricated pair; its H_0
// lies lower than the lubricated one by about the film. It goes by the flow of dry_flow.hpp.
#pragma once

#include <optional>

#include "dynamics/dry_flow.hpp"
#include "dynamics/run_store.hpp"
#include "mesh/dry_force.hpp"

namespace gearfilm {

class DryMarch {
public:
  /// Steps of the record at most dT long (the integration itself adapts its steps to 1e-10). A store must outlive the
  /// march.
  DryMarch(MeshModel mesh, double dT, StepObserver observer, double damping = 0.0, RunStore* store = nullptr);

  /// The motion in which the pair is at rest at a time.
  static Motion balance(const MeshModel& mesh, const DryForce& force, double T);

  /// Starts at the given motion, or at rest in balance.
  void start(const std::optional<Motion>& motion);
  /// One run of the march (run_store.hpp).
  void run(double T_end);

  const MeshModel& mesh() const { return mesh_; }
  double T() const { return T_; }
  const Motion& motion() const { return motion_; }

private:
  /// Calls the observer with these contacts.
  void observe(double dT, double wall_seconds, const std::vector<int>& numbers) const;

  MeshModel mesh_;
  DryForce force_;
  DryFlow flow_;
  double dT_;
  StepObserver observer_;
  RunStore* store_;
  double T_ = 0.0;
  Motion motion_;
};

}  // namespace gearfilm
