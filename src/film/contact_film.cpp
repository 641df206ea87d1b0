#include "film/contact_film.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "film/film_stencil.hpp"
#include "film/overshoot.hpp"
#include "film/pressure_spike.hpp"
#include "grid/domain.hpp"
#include "grid/integral.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
namespace {

/// Of levels of the preconditioner. Coarser ones see neither the rise of pressure in a thin film's inlet nor its fall
/// at the outlet: the conductances that they are given there differ by orders of magnitude, and their corrections
/// diverge.
double longest_level_step(const Scales& scales) { return 1.2 * inlet_rise(ExpectedFilm(scales)); }

/// Own rows whose films count.
RowRange rows_with_film(const Grid& grid, const Scales& scales) {
  return corners_carry_films(scales) ? RowRange{0, grid.y_count()} : grid.inner_rows();
}

}  // namespace

bool corners_carry_films(const Scales& scales) {
  return !scales.solids.face || scales.solids.face->end != EndFace::free;
}

ContactFilm::ContactFilm(SharedDiscretisation discretisation, const Scales& scales, const MultigridOptions& options)
    : discretisation_(std::move(discretisation)),
      grid_(discretisation_->grid()),
      deformation_(discretisation_->prepare_deformation<double>()),
      scales_(scales),
      surfaces_(surfaces_of(grid_, scales, {})),
      properties_(scales),
      state_(grid_),
      options_(options),
      longest_step_(longest_level_step(scales)),
      preconditioner_(make_linearised_film(*discretisation_, options, longest_step_)),
      displacement_column_(grid_.local_size()),
      smallest_scales_(grid_.y_count()),
      weights_(displacement_column_.size(), 1.0F),
      conductance_(displacement_column_.size()) {
  if (scales.solids.rough) state_.rough.emplace(grid_);
}

void ContactFilm::set_surfaces(ContactSurfaces surfaces) {
  surfaces_ = std::move(surfaces);
  set_heights();
  set_entrained();
  shown_ = 0;
}

void ContactFilm::set_flow_factors(FlowFactors factors) {
  flow_factors_ = std::move(factors);
  state_.across.reset();
  if (flow_factors_.sheared) state_.across.emplace(grid_).load(flow_factors_.cross_flow);
  set_entrained();
  shown_ = 0;
}

void ContactFilm::set_heights() {
  if (surfaces_.heights.empty()) {
    state_.heights.reset();
    return;
  }
  if (!state_.heights) state_.heights.emplace(grid_);
  for (int i = 0; i < grid_.nx(); ++i) {
    double* carried = state_.heights->row(i);
    const double* mass = surfaces_.heights.mass.data() + static_cast<std::size_t>(i) * grid_.y_count();
    for (int j = 0; j < grid_.y_count(); ++j) carried[j] = mass[j] * surfaces_.entrainment[j];
  }
}

void ContactFilm::set_entrained() {
  for (int i = 0; i < grid_.nx(); ++i) {
    double* entrained = state_.entrained.row(i);
    std::ranges::copy(surfaces_.entrainment, entrained);
    if (flow_factors_.empty()) continue;
    const double* wedge = flow_factors_.entrainment_excess.data() + static_cast<std::size_t>(i) * grid_.y_count();
    for (int j = 0; j < grid_.y_count(); ++j) entrained[j] += wedge[j];
  }
}

void ContactFilm::evaluate(std::span<const double> pressure, double H0, StateVersion state_version) {
  const At here{this, pressure, H0};
  evaluate_together({&here, 1}, state_version);
}

void ContactFilm::evaluate_together(std::span<const At> films, StateVersion state_version) {
  std::vector<const At*> others;
  std::vector<const Field<double>*> pressures;
  std::vector<Field<double>*> thicknesses;
  for (const At& at : films) {
    if (at.film->shows(at.H0, state_version)) continue;
    at.film->state_.total_pressure.load(at.pressure);
    others.push_back(&at);
    pressures.push_back(&at.film->state_.total_pressure);
    thicknesses.push_back(&at.film->state_.thickness);
  }
  if (others.empty()) return;
  others.front()->film->deformation_.apply(pressures, thicknesses);
  for (const At* at : others) at->film->complete_evaluation(at->H0, state_version);
}

void ContactFilm::complete_evaluation(double H0, StateVersion state_version) {
  ++convolutions_;
  for (int i = 0; i < grid_.nx(); ++i) {
    double* thickness = state_.thickness.row(i);
    const double* gap = surfaces_.gap.data() + static_cast<std::size_t>(i) * grid_.y_count();
    for (int j = 0; j < grid_.y_count(); ++j) thickness[j] += H0 + gap[j];
  }
  if (state_.rough) {
    gearfilm::evaluate(scales_, grid_, surfaces_.sliding, state_.total_pressure, state_.thickness, *state_.rough);
  }
  properties_.evaluate(state_, flow_factors_);
  exchange_ghosts(discretisation_->halo(), state_);
  shown_ = state_version;
  shown_H0_ = H0;
  at_linearised_ = false;
  rows_found_for_.reset();
}

void ContactFilm::residual(std::span<const double> pressure, double H0, const Squeeze& squeeze, std::span<double> rows,
                           StateVersion state_version) {
  evaluate(pressure, H0, state_version);
  at_linearised_ = false;
  find_rows(squeeze, rows);
}

void ContactFilm::find_rows(const Squeeze& squeeze, std::span<double> rows) {
  rows_found_for_ = squeeze;
  const std::vector<double>& transport = surfaces_.heights.transport;
  if (transport.empty()) {
    reynolds_residual(discretisation_->equation(), surfaces_.entrainment, state_, squeeze, rows);
    return;
  }
  std::vector<double> rate(transport.size(), 0.0);
  std::ranges::copy(squeeze.rate, rate.begin());
  for (std::size_t n = 0; n < rate.size(); ++n) rate[n] -= transport[n];
  reynolds_residual(discretisation_->equation(), surfaces_.entrainment, state_, {rate, squeeze.shift}, rows);
}

void ContactFilm::mass(std::span<const double> pressure, double H0, std::span<double> mass,
                       StateVersion state_version) {
  evaluate(pressure, H0, state_version);
  for (int i = 0; i < grid_.nx(); ++i) {
    const double* density = state_.density.row(i);
    const double* thickness = state_.mean_gap().row(i);
    double* line = mass.data() + static_cast<std::size_t>(i) * grid_.y_count();
    for (int j = 0; j < grid_.y_count(); ++j) line[j] = density[j] * thickness[j];
  }
  for (std::size_t n = 0; n < surfaces_.heights.mass.size(); ++n) mass[n] += surfaces_.heights.mass[n];
}

// In single precision the deformation has an error of 1e-7, which a short time step multiplies by its shift: beyond
// this ratio to the wedge Newton's method fails where pressures change fast.
LinearisedFilm& ContactFilm::linearisation_for(double shift) {
  constexpr double stiff = 8.0;
  if (options_.precision == Precision::double_precision || shift * grid_.h_x() < stiff * conditions().entrainment) {
    return *preconditioner_;
  }
  if (!double_preconditioner_) {
    MultigridOptions options = options_;
    options.precision = Precision::double_precision;
    double_preconditioner_ = make_linearised_film(*discretisation_, options, longest_step_);
  }
  return *double_preconditioner_;
}

void ContactFilm::linearise(std::span<const double> pressure, double H0, const Squeeze& squeeze, double shift,
                            StateVersion state_version, SmootherFactors factors) {
  evaluate(pressure, H0, state_version);
  // Which nodes are full, where no residual has just told.
  if (!rows_found_for_ || !rows_found_for_->is(squeeze)) find_rows(squeeze, displacement_column_);
  linearised_ = &linearisation_for(shift);
  linearised_->update(state_, shift, factors);
  linearised_->displacement_column(displacement_column_);
  at_linearised_ = true;
  if (state_.rough) {
    linearised_gap_.resize(pressure.size());
    state_.thickness.store(linearised_gap_);
  }
  const ReynoldsEquation& equation = discretisation_->equation();
  for (int j = 0; j < grid_.y_count(); ++j)
    smallest_scales_[j] = equation.row_scale(j, 0.0, surfaces_.entrainment[j], shift);
  for (int i = 0; i < grid_.nx(); ++i) {
    const StateLine line(state_, i);
    const double* scale = state_.row_scale.row(i);
    const std::size_t first = static_cast<std::size_t>(i) * grid_.y_count();
    float *weight = weights_.data() + first, *kept = conductance_.data() + first;
    for (int j = 0; j < grid_.y_count(); ++j) {
      weight[j] = static_cast<float>(smallest_scales_[j] / std::max(scale[j], smallest_scales_[j]));
      kept[j] = static_cast<float>(line.conductance(j));
    }
  }
}

void ContactFilm::multiply_together(std::span<const Product> products) {
  const ScopedEvent event(Kernel::jacobian_apply);
  std::vector<LinearisedFilm::Product> linearised;
  for (const Product& product : products) {
    linearised.push_back({product.film->linearised_, product.change, product.rows});
  }
  if (!linearised.front().film->multiply_together(linearised)) {
    for (const auto& [film, change, rows] : linearised) film->multiply(change, rows);
  }
  for (const auto& [film, change, change_H0, rows] : products) {
    ++film->convolutions_;
    if (change_H0 == 0.0) continue;
    const std::vector<double>& column = film->displacement_column_;
    for (std::size_t n = 0; n < rows.size(); ++n) rows[n] += change_H0 * column[n];
  }
}

void ContactFilm::multiply_mass(std::span<const double> change, double change_H0, std::span<double> rows) {
  if (!at_linearised_) throw std::logic_error("a film's Jacobian is used at a state at which it was not linearised");
  Field<double> changed(grid_), deformed(grid_);  // pressure, then rho H
  changed.load(change);
  deformation_.apply(changed, deformed);
  ++convolutions_;
  for (int i = 0; i < grid_.nx(); ++i) {
    const StateLine state(state_, i);
    const double *slope = state_.rough ? state_.rough->asperity_slope.row(i) : state_.zeros.data() + 1,
                 *of_gap = deformed.row(i);
    double* line = changed.row(i);
    for (int j = 0; j < grid_.y_count(); ++j) {
      const double gap = of_gap[j] + change_H0, oil_pressure = line[j] - slope[j] * gap;
      line[j] = state.rho[j] * state.h_H[j] * gap + state.rho_p[j] * state.h[j] * oil_pressure;
    }
  }
  apply_rates(discretisation_->equation(), state_, changed, deformed);
  deformed.store(rows);
}

double ContactFilm::merit(std::span<const double> rows) const {
  double sum = 0.0;
  const auto add = [&sum](double row) { sum += row * row; };
  if (!state_.rough) {
    for (std::size_t n = 0; n < rows.size(); ++n) add(rows[n] * weights_[n]);
    return sum;
  }
  // Scales of dry nodes change by factors with their gaps.
  for (int i = 0; i < grid_.nx(); ++i) {
    const double *scale = state_.row_scale.row(i), *full_film = state_.full_film.row(i);
    const std::size_t first = static_cast<std::size_t>(i) * grid_.y_count();
    for (int j = 0; j < grid_.y_count(); ++j) {
      const double weight = full_film[j] != 0.0 ? weights_[first + j] : smallest_scales_[j] / scale[j];
      add(rows[first + j] * weight);
    }
  }
  return sum;
}

double ContactFilm::gap_moved() const {
  if (linearised_gap_.empty()) return 0.0;
  constexpr double touching = 6.0, longest = 1.0;  // in sigma
  const double sigma = scales_.solids.rough->sigma() / scales_.thickness;
  double moved = 0.0;
  for (int i = 0; i < grid_.nx(); ++i) {
    const double* after = state_.thickness.row(i);
    const double* before = linearised_gap_.data() + static_cast<std::size_t>(i) * grid_.y_count();
    for (int j = 0; j < grid_.y_count(); ++j) {
      if (std::min(before[j], after[j]) < touching * sigma) moved = std::max(moved, std::abs(after[j] - before[j]));
    }
  }
  return moved / (longest * sigma);
}

bool ContactFilm::relax_overshot_nodes(std::span<double> change, std::span<const double> whole,
                                       std::span<const double> before, std::span<const double> after) const {
  bool relaxed = false;
  for (int i = 0; i < grid_.nx(); ++i) {
    const StateLine line(state_, i);
    for (int j = 0; j < grid_.y_count(); ++j) {
      const std::size_t n = static_cast<std::size_t>(i) * grid_.y_count() + j;
      if (change[n] <= 0.0 || conductance_[n] <= 0.0F) continue;  // pressures fall by positive changes
      const Overshoot node{.expected = smallest_scales_[j] / weights_[n] * whole[n],
                           .taken = change[n] / whole[n],
                           .before = before[n],
                           .after = after[n],
                           .growth = std::log(line.conductance(j) / conductance_[n])};
      if (!has_overshot(node)) continue;
      change[n] = part_to_take(node) * whole[n];
      relaxed = true;
    }
  }
  return relaxed;
}

void ContactFilm::precondition(std::span<const double> rows, std::span<double> change) {
  linearised_->apply(rows, change);
}

void ContactFilm::precondition_displacement(std::span<double> change) {
  if (!linearised_->relax_displacement(displacement_column_, change)) linearised_->apply(displacement_column_, change);
}

void ContactFilm::relax(std::span<const double> rows, std::span<double> change) { linearised_->relax(rows, change); }

FilmQuantities ContactFilm::quantities(std::span<const double> pressure, double H0, StateVersion state_version) {
  evaluate(pressure, H0, state_version);
  const double carried = integral(grid_, pressure);
  // The smallest film is minus the largest negative one; one reduction serves all.
  enum {
    largest,
    spike,
    negative_film,
    central_P,
    central_film,
    oil,
    asperities,
    asperity_row,
    negative_gap,
    central_gap,
    count
  };
  double maxima[count];
  std::ranges::fill(maxima, -INFINITY);
  // Where asperities carry, pressure is smooth on their scale: no grid misses a spike.
  constexpr double rubbing = 0.05;
  const double by_asperities = state_.rough ? asperity_integral(maxima[asperity_row]) : 0.0;
  maxima[spike] = by_asperities > rubbing * carried ? 0.0 : spike_pressure(grid_, state_.total_pressure);
  if (const int central = grid_.local_row(grid_.row_axis().central()); central >= 0) {
    // Linear between the lines beside X = 0: in thick films H and P have a slope there.
    const double place = -grid_.shape().x_min / grid_.h_x();
    const int before = std::clamp(static_cast<int>(place), 0, grid_.nx() - 2);
    const auto at_centre = [&](const Field<double>& field) {
      return std::lerp(field.row(before)[central], field.row(before + 1)[central], place - before);
    };
    maxima[central_P] = at_centre(state_.total_pressure);
    maxima[central_film] = at_centre(state_.thickness);
    maxima[central_gap] = at_centre(state_.mean_gap());
  }
  const RowRange rows = rows_with_film(grid_, scales_);
  for (int i = 0; i < grid_.nx(); ++i) {
    const double *P = state_.total_pressure.row(i), *P_f = state_.film_pressure().row(i),
                 *gap = state_.mean_gap().row(i), *H = state_.thickness.row(i);
    for (int j = rows.begin; j < rows.end; ++j) {
      maxima[largest] = std::max(maxima[largest], P[j]);
      maxima[oil] = std::max(maxima[oil], P_f[j]);
      maxima[asperities] = std::max(maxima[asperities], P[j] - P_f[j]);
      maxima[negative_film] = std::max(maxima[negative_film], -H[j]);
      maxima[negative_gap] = std::max(maxima[negative_gap], -gap[j]);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, maxima, count, MPI_DOUBLE, MPI_MAX, grid_.comm());
  // A maximum may pass over what is not a number; the integral does not.
  bool finite = std::isfinite(carried);
  if (!state_.rough) maxima[asperity_row] = 0.0;
  for (const double maximum : maxima) finite = finite && std::isfinite(maximum);
  return {.pressure_integral = carried,
          .central_film = maxima[central_film],
          .smallest_film = -maxima[negative_film],
          .central_pressure = maxima[central_P],
          .largest_pressure = maxima[largest],
          .spike_pressure = maxima[spike],
          .asperity_integral = by_asperities,
          .asperity_line = maxima[asperity_row],
          .central_mean_gap = maxima[central_gap],
          .smallest_mean_gap = -maxima[negative_gap],
          .largest_film_pressure = maxima[oil],
          .largest_asperity_pressure = maxima[asperities],
          .finite = finite};
}

double ContactFilm::asperity_integral(double& largest_of_row) const {
  std::vector<double> carried(static_cast<std::size_t>(grid_.local_size()));
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.y_count(); ++j) {
      carried[static_cast<std::size_t>(i) * grid_.y_count() + j] =
          asperity_pressure(*state_.rough, state_.total_pressure, i, j);
    }
  }
  for (int j = 0; j < grid_.y_count(); ++j) {
    double of_row = 0.0;
    for (std::size_t n = j; n < carried.size(); n += grid_.y_count()) of_row += grid_.h_x() * carried[n];
    largest_of_row = std::max(largest_of_row, of_row);
  }
  return integral(grid_, carried);
}

void hertz_pressure(const Grid& grid, const Scales& scales, const HertzContact& contact, std::span<double> pressure,
                    double centre) {
  const double top = contact.pressure / scales.pressure;
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) {
      const double x = (grid.x(i) - centre) * scales.length / contact.a, y = grid.y(j) * scales.length / contact.b;
      const double inside = 1.0 - x * x - y * y;
      const bool loaded = inside > 0.0 && !grid.is_boundary(i, j);
      pressure[static_cast<std::size_t>(i) * grid.y_count() + j] = loaded ? top * std::sqrt(inside) : 0.0;
    }
  }
}

}  // namespace gearfilm
