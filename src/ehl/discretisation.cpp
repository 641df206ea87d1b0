#include "gearfilm/ehl/discretisation.hpp"

namespace gearfilm {
namespace {

constexpr int fewest_rows_per_process = 2;

bool can_be_cut(const Grid& grid) { return grid.fewest_coarse_rows() >= fewest_rows_per_process; }

}  // namespace

Discretisation::Discretisation(Grid grid, double C_h) : grid_(std::move(grid)), C_h_(C_h), halo_(grid_) {}

template <>
const Deformation<double>& Discretisation::deformation<double>() const {
  if (!deformation_) deformation_ = std::make_unique<const Deformation<double>>(grid_, C_h_);
  return *deformation_;
}

template <>
const Deformation<float>& Discretisation::deformation<float>() const {
  if (!single_deformation_) single_deformation_ = std::make_unique<const Deformation<float>>(grid_, C_h_);
  return *single_deformation_;
}

const Discretisation* Discretisation::coarser() const {
  if (!grid_.can_coarsen() || !can_be_cut(grid_)) return nullptr;
  if (!coarser_) coarser_ = std::make_unique<const Discretisation>(grid_.coarsened(), C_h_);
  return coarser_.get();
}

const Discretisation* Discretisation::before() const {
  if (2.0 * grid_.h_x() > grid_.h_y() || grid_.nx() % 4 != 1) return coarser();
  if (!coarser_in_x_) coarser_in_x_ = std::make_unique<const Discretisation>(grid_.coarsened_in_x(), C_h_);
  return coarser_in_x_.get();
}

const Discretisation* Discretisation::whole() const {
  if (!grid_.can_coarsen() || can_be_cut(grid_)) return nullptr;
  if (!whole_) whole_ = std::make_unique<const Discretisation>(grid_.gathered(), C_h_);
  return whole_.get();
}

const Gather& Discretisation::gather() const {
  if (!gather_) gather_ = std::make_unique<const Gather>(grid_);
  return *gather_;
}

SharedDiscretisation discretise(const Grid& grid, const Scales& scales) {
  return std::make_shared<const Discretisation>(grid, scales.C_h);
}

}  // namespace gearfilm
