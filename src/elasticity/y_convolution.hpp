// The convolution with K in y, between the transforms in x of rows and those of their deformation (deformation.hpp).
#pragma once

#include <functional>
#include <stdexcept>

#include "elasticity/field_pair_spectra.hpp"
#include "elasticity/x_spectra.hpp"

namespace gearfilm {

/// K between nodes that are i lines and j rows apart.
using Influence = std::function<double(int i, int j)>;
/// Deformation at a row, i lines away, under unit pressure on the cell of a source row; its mirror image included.
using RowInfluence = std::function<double(int i, int row, int source)>;

template <class Real>
class YConvolution {
public:
  virtual ~YConvolution() = default;
  YConvolution() = default;
  YConvolution(const YConvolution&) = delete;
  YConvolution& operator=(const YConvolution&) = delete;

  /// The spectra of rows become those of their deformation. All processes of the grid call it together.
  virtual void apply(XSpectra<Real>& spectra) = 0;
  /// Whether two fields at once are the faster way, and the same for two.
  virtual bool serves_pairs() const { return false; }
  virtual void apply(FieldPairSpectra<Real>& /*spectra*/) {
    throw std::logic_error("fields are not convolved in pairs");
  }
};

}  // namespace gearfilm
