// A field cut among the processes, whole on every process: for grids too small to be cut.
#pragma once

#include "grid/grid.hpp"

namespace gearfilm {

/// Between compact fields of a distributed grid and of the same grid gathered.
class Gather {
public:
  /// The grid must outlive the object.
  explicit Gather(const Grid& grid);

  /// Own part -> whole field, on all processes. Collective.
  void to_all(std::span<const double> own, std::span<double> whole) const;
  /// Whole field -> own part.
  void own_part(std::span<const double> whole, std::span<double> own) const;

private:
  using OwnedScatter = PetscHandle<VecScatter, VecScatterDestroy>;

  const Grid& grid_;
  OwnedScatter to_natural_;  ///< from compact fields to the natural order of the DMDA, which is that of whole fields
};

}  // namespace gearfilm
