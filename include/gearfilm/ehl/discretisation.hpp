// What all films on one grid share: the grid, its ghosts, the transforms of the deformation, and the same of every
// coarser grid. It depends on the grid and on C_h alone, so a further contact costs its fields only.
#pragma once

#include <array>
#include <memory>

#include "gearfilm/contact/scales.hpp"
#include "gearfilm/ehl/deformation.hpp"
#include "gearfilm/ehl/gather.hpp"
#include "gearfilm/ehl/halo.hpp"

namespace gearfilm {

/// Immutable to its users. Parts that not every use needs are made when they are first asked for, collectively; the
/// work space of the transforms is shared too, so that one film at a time is deformed.
class Discretisation {
public:
  /// C_h as in Scales.
  Discretisation(Grid grid, double C_h);
  Discretisation(const Discretisation&) = delete;
  Discretisation& operator=(const Discretisation&) = delete;

  const Grid& grid() const { return grid_; }
  const Halo& halo() const { return halo_; }
  /// K in either precision.
  template <class Real>
  const Deformation<Real>& deformation() const;

  /// Every second node along either direction or one, cut likewise among the processes; null where that would leave a
  /// process fewer than two rows, or where there are too few nodes.
  const Discretisation* coarser(Coarsening along = Coarsening::both) const;
  /// The grid before this one where a film is found on finer and finer grids: every second line while cells
  /// are long across, else coarser(). Across, a slender contact's lines are few, and its edge moves by
  /// many cells from one to the next: a film cannot be interpolated between them.
  const Discretisation* before() const;
  /// Where coarser(y_only) is null though there are nodes enough: this grid, whole on every process, for the rest of
  /// the hierarchy; null otherwise.
  const Discretisation* whole() const;
  /// Between this grid and whole().
  const Gather& gather() const;

private:
  Grid grid_;
  double C_h_;
  Halo halo_;
  mutable std::unique_ptr<const Deformation<double>> deformation_;
  mutable std::unique_ptr<const Deformation<float>> single_deformation_;
  mutable std::array<std::unique_ptr<const Discretisation>, 3> coarser_;  ///< by Coarsening
  mutable std::unique_ptr<const Discretisation> whole_;
  mutable std::unique_ptr<const Gather> gather_;
};

using SharedDiscretisation = std::shared_ptr<const Discretisation>;

SharedDiscretisation discretise(const Grid& grid, const Scales& scales);

}  // namespace gearfilm
