// Deformation by rows that were relaxed one by one.
//
// Whoever relaxes whole rows leaves out by how much their changes of pressure z displace one another. At a distance
// the load of a row counts, not where along X it acts: the displacement s_j of row j by the loads F_l of all others is
//
//   s_j = sum_l k_jl F_l ,      F_l = sum_i z_il - S_l s_l ,
//
// S_l being by how much the row gives up of its load where it is displaced by 1: the sum of its response f_l, the
// changes of pressure that its own matrix answers with. So (I + k S) s = k F for the loads F of z, and z_l becomes
// z_l - f_l s_l. The compliance k_jl is the deformation at |X| = 1 beside a strip of row l: far from it that of the
// whole row j, and near it the smaller part that is alike for all X.
#pragma once

#include <vector>

#include "elasticity/deformation.hpp"
#include "film/film_stencil.hpp"
#include "film/row_factors.hpp"
#include "grid/halo.hpp"

namespace gearfilm {

template <class Real>
class DeformationBetweenRows {
public:
  DeformationBetweenRows(const Grid& grid, const Deformation<PartOf<Real>>& deformation);

  /// From the responses of the own rows.
  void factor(Field<Real> responses);
  const Field<Real>& responses() const { return responses_; }
  /// change: z - f s in the place of z.
  void correct(Field<Real>& change);

private:
  using Part = PartOf<Real>;

  Part& compliance(int row, int source) { return compliance_[static_cast<std::size_t>(source) * count_ + row]; }
  /// Over the lines of every row, those of all processes.
  std::vector<Real> sums(const Field<Real>& field) const;

  MPI_Comm comm_;
  RowRange own_;
  int count_;                     ///< rows of all processes
  std::vector<Part> compliance_;  ///< k
  Field<Real> responses_;         ///< f
  RowFactors<Real> factors_;      ///< of I + k S
};

extern template class DeformationBetweenRows<float>;
extern template class DeformationBetweenRows<double>;
extern template class DeformationBetweenRows<std::complex<double>>;

}  // namespace gearfilm
