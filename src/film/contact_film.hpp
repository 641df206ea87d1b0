// The film of one contact on one grid: the nonlinear equations in (P, H_0), their exact Jacobian, a preconditioner.
//
//   H = H_0 + E + K P                   film thickness (24), E of contact_surfaces.hpp, K of deformation.hpp
//   G(P, H_0; d(rho H)/dT) = min(d P, R)        Reynolds' equation with cavitation, reynolds.hpp
// Between rough surfaces with P - P_a(H) in the place of the second P, and the mean gap in that of H (rough_gap.hpp).
// Source: doi 10.1016/j.triboint.2013.01.017. Every solver (stationary, transient) is built on this class; none of
// them sees how a film is discretised. Arrays are compact (nx*y_count values of this process, y contiguous). Calls
// that depend on a state take it, and the version of its pressures where they have one (state_version.hpp). The film
// that it shows already, of the same version and H_0, is not computed again.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "elasticity/deformation.hpp"
#include "film/contact_surfaces.hpp"
#include "film/linearised_film.hpp"
#include "film/reynolds.hpp"
#include "parallel/state_version.hpp"

namespace gearfilm {

/// Quantities of a film that are common to all processes; dimensionless.
struct FilmQuantities {
  double pressure_integral = 0.0;  ///< Int Int P dX dY
  double central_film = 0.0;       ///< H at the node nearest X = Y = 0
  double smallest_film = 0.0;      ///< H; between rough surfaces it may be negative
  double central_pressure = 0.0;
  double largest_pressure = 0.0;
  double spike_pressure = 0.0;  ///< of the outlet's spike (pressure_spike.hpp); zero where there is none
  // Between smooth surfaces the mean gap is the film, and the oil has all the pressure.
  double asperity_integral = 0.0;  ///< Int Int P_a dX dY
  double asperity_line = 0.0;      ///< Int P_a dX of the row where it is largest
  double central_mean_gap = 0.0;   ///< h in the place of H
  double smallest_mean_gap = 0.0;
  double largest_film_pressure = 0.0;
  double largest_asperity_pressure = 0.0;
  bool finite = true;  ///< false where any pressure or film is not a number
};

/// At free ends of a face, where P = 0, the film beneath the edge itself is thinner than any step of rows resolves, and
/// it carries nothing: it is no film of the model.
bool corners_carry_films(const Scales& scales);

class ContactFilm {
public:
  ContactFilm(SharedDiscretisation discretisation, const Scales& scales, const MultigridOptions& options);

  const SharedDiscretisation& discretisation() const { return discretisation_; }
  const Grid& grid() const { return grid_; }
  const Scales& scales() const { return scales_; }
  const ContactSurfaces& surfaces() const { return surfaces_; }
  const ContactConditions& conditions() const { return surfaces_.conditions; }
  void set_surfaces(ContactSurfaces surfaces);
  /// Leaves only what the surfaces press on each other, of rough ones: all nodes dry.
  void set_without_oil(bool without) { state_.without_oil = without; }
  /// Weights of rates in the wedge.
  void set_rates_in_wedge(const FaceWeights& weights) { state_.of_rates = weights; }
  const FlowFactors& flow_factors() const { return flow_factors_; }
  void set_flow_factors(FlowFactors factors);

  // Collective, all of them.

  /// Film and oil at (pressure, H_0), which state() and the fields then show.
  void evaluate(std::span<const double> pressure, double H0, StateVersion state_version = 0);
  /// Evaluates films on one discretisation, each at its (pressure, H_0); their deformations are computed together.
  struct At {
    ContactFilm* film;
    std::span<const double> pressure;
    double H0;
  };
  static void evaluate_together(std::span<const At> films, StateVersion state_version);
  FilmQuantities quantities(std::span<const double> pressure, double H0, StateVersion state_version = 0);
  /// rows = G at (pressure, H_0).
  void residual(std::span<const double> pressure, double H0, const Squeeze& squeeze, std::span<double> rows,
                StateVersion state_version = 0);
  /// mass = rho h, h the mean gap, between smooth surfaces H, at (pressure, H_0), with q of heights that travel: what
  /// the time scheme differentiates.
  void mass(std::span<const double> pressure, double H0, std::span<double> mass, StateVersion state_version = 0);

  /// Makes the Jacobian at (pressure, H_0), with d(rate)/d(rho H) = shift, for the calls below. The squeeze term
  /// says which nodes are full.
  void linearise(std::span<const double> pressure, double H0, const Squeeze& squeeze, double shift,
                 StateVersion state_version = 0, SmootherFactors factors = SmootherFactors::of_this_state);
  /// Whether the Jacobian is computed in single precision.
  bool in_single_precision() const {
    return options_.precision == Precision::single_precision && linearised_ == preconditioner_.get();
  }
  /// rows = dG/dP change + dG/dH_0 change_H0.
  void multiply(std::span<const double> change, double change_H0, std::span<double> rows) {
    const Product product{this, change, change_H0, rows};
    multiply_together({&product, 1});
  }
  /// Products with the Jacobians of films on one discretisation, whose deformations are computed together.
  struct Product {
    ContactFilm* film;
    std::span<const double> change;
    double change_H0;
    std::span<double> rows;
  };
  static void multiply_together(std::span<const Product> products);
  /// rows = the part of multiply() that grows with the shift: the change of rho H, zero where cavitated. It reads the
  /// state: an error once another one was evaluated.
  void multiply_mass(std::span<const double> change, double change_H0, std::span<double> rows);
  /// change = approximately (dG/dP)^-1 rows.
  void precondition(std::span<const double> rows, std::span<double> change);
  /// change = approximately (dG/dP)^-1 dG/dH_0.
  void precondition_displacement(std::span<double> change);
  /// Approximate solution as above, by one relaxation of the smoother.
  void relax(std::span<const double> rows, std::span<double> change);
  /// Whether oil flows freely at an own node of the state of the Jacobian (reynolds.hpp). Not collective.
  bool conducts_freely(std::size_t n) const { return gearfilm::conducts_freely(weights_[n]); }
  /// Makes a change of the pressure that would leave some below zero at such nodes one that leaves them there
  /// (projected_change.hpp). Not collective.
  void project_change(std::span<const double> pressure, std::span<double> change) {
    linearised_->project_change(pressure, weights_, change);
  }
  /// Sum of the squares of own rows, each relative to the scale of its node where that is large: in thick film, whose
  /// pressures follow all others, tiny changes of pressure make huge rows.
  double merit(std::span<const double> rows) const;
  /// Shortens the own nodes' changes that have overshot (overshoot.hpp) in a step whose end was evaluated last, with
  /// these rows before and after it; false where there are none. Not collective.
  bool relax_overshot_nodes(std::span<double> change, std::span<const double> whole, std::span<const double> before,
                            std::span<const double> after) const;
  /// How far the gap between rough surfaces of the state that was evaluated last is from that of the Jacobian where
  /// asperities may touch, over what their pressure lets it move in one iteration. Not collective.
  double gap_moved() const;
  /// dG/dH_0.
  std::span<const double> displacement_column() const { return displacement_column_; }

  // Of the state that was evaluated last.
  const FilmState& state() const { return state_; }
  const Field<double>& total_pressure() const { return state_.total_pressure; }
  const Field<double>& film_pressure() const { return state_.film_pressure(); }
  const Field<double>& thickness() const { return state_.thickness; }
  const Field<double>& mean_gap() const { return state_.mean_gap(); }
  /// Convolutions so far on this grid, but for those of the preconditioner.
  long convolutions() const { return convolutions_; }

private:
  bool shows(double H0, StateVersion state_version) const {
    return state_version != 0 && state_version == shown_ && H0 == shown_H0_;
  }
  /// Film and oil where the thickness holds the deformation by the pressure.
  void complete_evaluation(double H0, StateVersion state_version);
  LinearisedFilm& linearisation_for(double shift);
  /// Int Int P_a, and the largest Int P_a dX of own rows.
  double asperity_integral(double& largest_of_row) const;
  void set_entrained();
  void set_heights();
  /// G of the state that is shown.
  void find_rows(const Squeeze& squeeze, std::span<double> rows);

  SharedDiscretisation discretisation_;
  const Grid& grid_;
  const Deformation<double>& deformation_;
  Scales scales_;
  ContactSurfaces surfaces_;
  FlowFactors flow_factors_;
  FilmProperties properties_;
  FilmState state_;
  MultigridOptions options_;
  double longest_step_;                             ///< along X, of the preconditioner's levels
  std::unique_ptr<LinearisedFilm> preconditioner_;  ///< in the precision of the options
  std::unique_ptr<LinearisedFilm>
      double_preconditioner_;                ///< in double precision, for stiff squeezing; made when first needed
  LinearisedFilm* linearised_ = nullptr;     ///< the last one of them
  bool at_linearised_ = false;               ///< the evaluated state is that of the Jacobian
  std::optional<Squeeze> rows_found_for_{};  ///< with which squeeze term rows of the evaluated state were found last
  std::vector<double> linearised_gap_;       ///< H there, of rough surfaces
  std::vector<double> displacement_column_;  ///< dG/dH_0
  std::vector<double> smallest_scales_;      ///< d of a node that conducts nothing, by row
  std::vector<float> weights_;               ///< of rows in the merit: the smallest d over d
  std::vector<float> conductance_;           ///< xi_R at the state of the Jacobian
  StateVersion shown_ = 0;  ///< of the pressures of state_; 0 where surfaces or correction have changed since
  double shown_H0_ = 0.0;
  long convolutions_ = 0;
};

/// Pressure of a dry contact about X = centre on the own nodes, zero on the boundary; compact.
void hertz_pressure(const Grid& grid, const Scales& scales, const HertzContact& contact, std::span<double> pressure,
                    double centre = 0.0);

}  // namespace gearfilm
