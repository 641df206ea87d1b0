// What all films on one grid share: the grid, its ghosts, how flows follow from nodes, the transforms of the
// deformation, and the same of every coarser grid. A further contact costs its fields only.
#pragma once

#include <array>
#include <memory>

#include "contact/scales.hpp"
#include "elasticity/deformation.hpp"
#include "elasticity/row_contact.hpp"
#include "film/reynolds.hpp"
#include "grid/gather.hpp"
#include "grid/halo.hpp"
#include "stress/row_stress.hpp"

namespace gearfilm {

/// Parts that not every use needs are made by calls that begin with `prepare`, all of them collective and without
/// effect where the part is there. The work space of the transforms is shared too, so that one film at a time is
/// deformed.
class Discretisation {
public:
  /// C_h as in Scales; ends of the face, where the rows reach them.
  Discretisation(Grid grid, double C_h, FilmDiscretisation of_films, EndFaces ends = {});
  Discretisation(const Discretisation&) = delete;
  Discretisation& operator=(const Discretisation&) = delete;

  const Grid& grid() const { return grid_; }
  const Halo& halo() const { return halo_; }
  const ReynoldsEquation& equation() const { return equation_; }
  FilmDiscretisation of_films() const { return equation_.discretisation; }
  /// K in either precision.
  template <class Real>
  const Deformation<Real>& prepare_deformation();

  /// The dry contact on the rows of a whole face, as if none had been solved; of scales that have one.
  RowContact& prepare_row_contact(const Scales& scales);
  /// Stresses in a section below films on this grid; there is one at a time.
  RowStress& prepare_stress(const RowStressOptions& options);

  /// Every second node along either direction or one, cut likewise among the processes; null where that would leave a
  /// process fewer than two rows, or where there are too few nodes.
  Discretisation* prepare_coarser(Coarsening along = Coarsening::both);
  /// The next coarser grid of a sequence on which a film is found from the coarsest to the finest: every second line
  /// while cells are long across, else that of every second node. Across, a slender contact's lines are few, and its
  /// edge moves by many cells from one to the next: a film cannot be interpolated between them.
  Discretisation* prepare_sequencing_grid();
  /// Where prepare_coarser(y_only) is null though there are nodes enough: this grid, whole on every process, for the
  /// rest of a hierarchy; null otherwise.
  Discretisation* prepare_replicated();
  /// What prepare_replicated() has made.
  const Discretisation* replicated() const { return replicated_.get(); }
  /// Between this grid and the replicated one.
  const Gather& prepare_gather();

private:
  std::shared_ptr<const EndFaceCompliance> prepare_ends();

  Grid grid_;
  double C_h_;
  EndFaces ends_;
  std::shared_ptr<const EndFaceCompliance> end_compliance_;
  Halo halo_;
  ReynoldsEquation equation_;
  std::unique_ptr<const Deformation<double>> deformation_;
  std::unique_ptr<const Deformation<float>> single_deformation_;
  std::array<std::unique_ptr<Discretisation>, 3> coarser_;  ///< by Coarsening
  std::unique_ptr<Discretisation> replicated_;
  std::unique_ptr<const Gather> gather_;
  std::unique_ptr<RowContact> row_contact_;
  std::unique_ptr<RowStress> row_stress_;
};

using SharedDiscretisation = std::shared_ptr<Discretisation>;

SharedDiscretisation discretise(const Grid& grid, const Scales& scales,
                                FilmDiscretisation of_films = FilmDiscretisation::fitted);

}  // namespace gearfilm
