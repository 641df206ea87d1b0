// The convolution with K in y, between the transforms in x of rows and those of their deformation (deformation.hpp).
#pragma once

#include <functional>

#include "gearfilm/elasticity/row_spectra.hpp"

namespace gearfilm {

/// K between nodes that are i lines and j rows apart.
using Influence = std::function<double(int i, int j)>;

template <class Real>
class AcrossRows {
public:
  virtual ~AcrossRows() = default;
  AcrossRows() = default;
  AcrossRows(const AcrossRows&) = delete;
  AcrossRows& operator=(const AcrossRows&) = delete;

  /// The spectra of rows become those of their deformation. All processes of the grid call it together.
  virtual void apply(RowSpectra<Real>& spectra) = 0;
};

}  // namespace gearfilm
