// A march of the pair, dry or on its films, behind one interface.
#pragma once

#include <variant>

#include "dynamics/dry_pair.hpp"
#include "dynamics/pair_numerics.hpp"

namespace gearfilm {

class PairMarch {
public:
  /// A march on films of a discretisation.
  PairMarch(const MeshModel& mesh, const PairNumerics& numerics, const SharedDiscretisation& films,
            StepObserver observer, RunStore* store = nullptr)
      : march_(make_march(mesh, numerics, films, std::move(observer), store)) {}
  /// Dry, with a damper of this ratio beside the contacts and steps of the record at most dT long.
  PairMarch(const MeshModel& mesh, double dT, double damping_ratio, StepObserver observer, RunStore* store = nullptr)
      : march_(DryMarch(mesh, dT, std::move(observer), dry_damping(mesh, damping_ratio), store)) {}

  /// Starts at the given motion, or at rest.
  void start(const std::optional<Motion>& motion) {
    std::visit([&](auto& march) { march.start(motion); }, march_);
  }
  void run(double T_end) {
    std::visit([&](auto& march) { march.run(T_end); }, march_);
  }
  double T() const {
    return std::visit([](const auto& march) { return march.T(); }, march_);
  }
  /// Grid of the present films; nothing for a dry march.
  std::optional<GridShape> grid_shape() const {
    const auto* on_films = std::get_if<MeshMarch>(&march_);
    return on_films ? std::optional(on_films->discretisation()->grid().shape()) : std::nullopt;
  }

private:
  std::variant<MeshMarch, DryMarch> march_;
};

}  // namespace gearfilm
