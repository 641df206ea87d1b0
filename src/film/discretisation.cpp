#include "film/discretisation.hpp"

namespace gearfilm {
namespace {

constexpr int fewest_rows_per_process = 2;

bool can_be_cut(const Grid& grid) { return grid.keeps_rows() || grid.fewest_coarse_rows() >= fewest_rows_per_process; }

}  // namespace

Discretisation::Discretisation(Grid grid, double C_h, FilmDiscretisation of_films, EndFaces ends)
    : grid_(std::move(grid)), C_h_(C_h), ends_(std::move(ends)), halo_(grid_), equation_(grid_, C_h, of_films) {}

std::shared_ptr<const EndFaceCompliance> Discretisation::prepare_ends() {
  if (ends_.act() && !end_compliance_) {
    end_compliance_ = std::make_shared<const EndFaceCompliance>(grid_.shape(), ends_);
  }
  return end_compliance_;
}

template <>
const Deformation<double>& Discretisation::prepare_deformation<double>() {
  if (!deformation_) deformation_ = std::make_unique<const Deformation<double>>(grid_, C_h_, prepare_ends());
  return *deformation_;
}

template <>
const Deformation<float>& Discretisation::prepare_deformation<float>() {
  if (!single_deformation_)
    single_deformation_ = std::make_unique<const Deformation<float>>(grid_, C_h_, prepare_ends());
  return *single_deformation_;
}

RowContact& Discretisation::prepare_row_contact(const Scales& scales) {
  if (!row_contact_) {
    row_contact_ = std::make_unique<RowContact>(scales, grid_.row_axis());
    if (const auto ends = prepare_ends()) row_contact_->add_ends(*ends, grid_.h_x());
  }
  row_contact_->begin_anew();  // runs that go on meet the same contacts
  return *row_contact_;
}

RowStress& Discretisation::prepare_stress(const RowStressOptions& options) {
  if (!row_stress_ || row_stress_->options() != options) row_stress_ = std::make_unique<RowStress>(grid_, options);
  return *row_stress_;
}

Discretisation* Discretisation::prepare_coarser(Coarsening along) {
  if (!grid_.can_coarsen(along) || (along != Coarsening::x_only && !can_be_cut(grid_))) return nullptr;
  auto& made = coarser_[static_cast<std::size_t>(along)];
  if (!made) made = std::make_unique<Discretisation>(grid_.coarsened(along), C_h_, of_films(), ends_);
  return made.get();
}

Discretisation* Discretisation::prepare_sequencing_grid() {
  return prepare_coarser(needs_all_rows(grid_) && grid_.nx() % 4 == 1 ? Coarsening::x_only : Coarsening::both);
}

Discretisation* Discretisation::prepare_replicated() {
  if (!grid_.can_coarsen(Coarsening::y_only) || can_be_cut(grid_)) return nullptr;
  if (!replicated_) replicated_ = std::make_unique<Discretisation>(grid_.gathered(), C_h_, of_films(), ends_);
  return replicated_.get();
}

const Gather& Discretisation::prepare_gather() {
  if (!gather_) gather_ = std::make_unique<const Gather>(grid_);
  return *gather_;
}

SharedDiscretisation discretise(const Grid& grid, const Scales& scales, FilmDiscretisation of_films) {
  return std::make_shared<Discretisation>(grid, scales.C_h, of_films,
                                          scales.solids.face ? ends_of(*scales.solids.face) : EndFaces{});
}

}  // namespace gearfilm
