// The film of one contact on one grid: the nonlinear equations in (P, H_0), their exact Jacobian, a preconditioner.
//
//   H = H_0 + offset + X^2/(2 Rbar) + D Y^2/2 + K P            film thickness (24), K of deformation.hpp
//   G(P, H_0) = min(d P, R)                                    Reynolds' equation with cavitation, reynolds.hpp
// Source: doi 10.1016/j.triboint.2013.01.017. Every solver (stationary, transient) is built on this class; none of
// them sees how a film is discretised. Arrays are compact (nx*y_count values of this process, y contiguous).
#pragma once

#include <memory>
#include <vector>

#include "gearfilm/ehl/contact_conditions.hpp"
#include "gearfilm/ehl/deformation.hpp"
#include "gearfilm/ehl/preconditioner.hpp"
#include "gearfilm/ehl/reynolds.hpp"

namespace gearfilm {

/// Figures of a film that are common to all processes; dimensionless.
struct FilmFigures {
  double pressure_integral = 0.0;  ///< Int Int P dX dY
  double central_film = 0.0;       ///< H at the node nearest X = Y = 0
  double smallest_film = 0.0;
  double central_pressure = 0.0;
  double largest_pressure = 0.0;
  bool finite = true;  ///< false where any pressure or film is not a number
};

class ContactFilm {
public:
  ContactFilm(SharedDiscretisation discretisation, const Scales& scales, const MultigridOptions& options);

  const SharedDiscretisation& discretisation() const { return discretisation_; }
  const Grid& grid() const { return grid_; }
  const Scales& scales() const { return scales_; }
  const ContactConditions& conditions() const { return conditions_; }
  void set_conditions(const ContactConditions& conditions);

  /// Film and oil at (pressure, H_0), which figures() and the fields then describe.
  void evaluate(const double* pressure, double H0);
  /// G at (pressure, H_0). Film and oil are not computed again when the state is the one of the last call.
  void residual(const double* pressure, double H0, const Squeeze& squeeze, double* residual);
  /// rho H at (pressure, H_0): what the time scheme differentiates.
  void storage(const double* pressure, double H0, double* storage);

  /// Prepares multiply() and precondition() at the state of the last residual().
  void linearise(double storage_shift);
  /// rows = dG/dP change + dG/dH_0 change_H0.
  void multiply(const double* change, double change_H0, double* rows);
  /// The part of multiply() that grows with the storage shift: the change of rho H, zero where cavitated.
  void multiply_storage(const double* change, double change_H0, double* rows);
  /// dG/dH_0.
  const std::vector<double>& film_shift() const { return film_shift_; }
  /// change = approximately (dG/dP)^-1 residual.
  void precondition(const double* residual, double* change) { linearised_->apply(residual, change); }

  /// Of the last state.
  FilmFigures figures() const;
  const FilmState& state() const { return state_; }
  const Field<double>& pressure() const { return state_.pressure; }
  const Field<double>& film() const { return state_.film; }
  /// Convolutions so far on this grid, but for those of the preconditioner.
  long convolutions() const { return convolutions_; }

private:
  bool is_current(const double* pressure, double H0) const;
  FilmPreconditioner& linearisation_for(double storage_shift);

  SharedDiscretisation discretisation_;
  const Grid& grid_;
  const Deformation<double>& deformation_;
  Scales scales_;
  ContactConditions conditions_;
  FilmProperties properties_;
  FilmState state_;
  MultigridOptions options_;
  std::unique_ptr<FilmPreconditioner> usual_;   ///< in the precision of the options
  std::unique_ptr<FilmPreconditioner> double_;  ///< for stiff squeezing; made when first needed
  FilmPreconditioner* linearised_ = nullptr;    ///< the one of them that is prepared
  std::vector<double> film_shift_;              ///< dG/dH_0
  Field<double> change_, deformed_;
  std::vector<double> evaluated_pressure_;
  double evaluated_H0_ = 0.0;
  bool evaluated_ = false;
  long convolutions_ = 0;
};

/// Pressure of a dry contact on the own nodes, zero on the boundary; compact.
void hertz_pressure(const Grid& grid, const Scales& scales, const HertzContact& contact, double* pressure);

}  // namespace gearfilm
