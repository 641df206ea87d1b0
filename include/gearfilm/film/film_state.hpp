// The film at every node: pressures, film thickness, and the oil properties that enter Reynolds' equation.
//
// The total pressure is the unknown: it deforms the solids and carries the load. The film pressure is that of the oil:
// it drives the flow, sets viscosity and density, and cavitates. Between smooth surfaces both are the same.
//
//   conductance xi_R = rho H^3/(eta lambda)          (22) of doi 10.1016/j.triboint.2013.01.017
// with the factors of flow_factors.hpp; all dimensionless, rho and eta relative to ambient. Derivatives are kept
// beside the values: the exact Jacobian and every coarser level of the preconditioner are made from them without
// evaluating the oil again.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearfilm/contact/scales.hpp"
#include "gearfilm/film/flow_factors.hpp"
#include "gearfilm/grid/halo.hpp"

namespace gearfilm {

struct FilmState {
  explicit FilmState(const Grid& grid)
      : total_pressure(grid),
        thickness(grid),
        density(grid),
        density_by_pressure(grid),
        conductance(grid),
        conductance_by_pressure(grid),
        conductance_by_thickness(grid),
        entrained(grid),
        full_film(grid),
        row_scale(grid),
        ones(static_cast<std::size_t>(thickness.stride()), 1.0) {
    entrained.fill(1.0);
  }

  /// Pressure of the oil in units of the Hertz pressure, on own nodes and ghosts.
  const Field<double>& film_pressure() const { return total_pressure; }
  Field<double>& film_pressure() { return total_pressure; }

  Field<double> total_pressure;            ///< P
  Field<double> thickness;                 ///< H
  Field<double> density;                   ///< rho
  Field<double> density_by_pressure;       ///< d rho/dP
  Field<double> conductance;               ///< xi_R
  Field<double> conductance_by_pressure;   ///< d xi_R/dP at constant H
  Field<double> conductance_by_thickness;  ///< d xi_R/dH at constant P
  Field<double> entrained;                 ///< U + W, with which the wedge carries oil
  Field<double> full_film;                 ///< 1 where Reynolds' equation holds, 0 where P = 0 (cavitated, boundary)
  Field<double> row_scale;                 ///< d, the factor of P in the row of a node that is not full
  std::optional<Field<double>> across{};   ///< A, the conductance in y over that in x; absent, on all processes, where
                                           ///< it is 1 everywhere
  std::vector<double> ones;                ///< of a line with its ghosts, for lines of A where that is absent

  /// A of line i, with ghosts.
  const double* across_row(int i) const { return across ? across->row(i) : ones.data() + 1; }
};

/// All fields of a state but A, for what treats them alike (injection, gathering).
inline constexpr std::array<Field<double> FilmState::*, 10> state_fields = {&FilmState::total_pressure,
                                                                            &FilmState::thickness,
                                                                            &FilmState::density,
                                                                            &FilmState::density_by_pressure,
                                                                            &FilmState::conductance,
                                                                            &FilmState::conductance_by_pressure,
                                                                            &FilmState::conductance_by_thickness,
                                                                            &FilmState::entrained,
                                                                            &FilmState::full_film,
                                                                            &FilmState::row_scale};

/// Oil properties of one contact in dimensionless form.
class FilmProperties {
public:
  explicit FilmProperties(const Scales& scales)
      : viscosity_(viscosity_evaluator(scales.oil)),
        density_(density_evaluator(scales.oil)),
        pressure_scale_(scales.pressure),
        inverse_lambda_(1.0 / scales.lambda) {}

  /// Fills density, conductance and their derivatives from pressure and film on the own nodes. A film H < 0 (met
  /// only inside an iteration) conducts nothing.
  void evaluate(FilmState& state, const FlowFactors& factors = {}) const;

private:
  template <EvaluatesViscosity Viscosity, EvaluatesDensity Density>
  void evaluate_line(Viscosity viscosity, Density density_law, FilmState& state, int i) const;
  template <bool sheared, EvaluatesViscosity Viscosity>
  void correct_line(Viscosity viscosity, FilmState& state, int i, const FlowFactors& factors) const;

  ViscosityEvaluator viscosity_;
  DensityEvaluator density_;
  double pressure_scale_;
  double inverse_lambda_;
};

/// Exchanges what stencils read from the neighbouring rows: pressure, conductance and its derivatives, and A where it
/// is not one.
void exchange_ghosts(const Halo& halo, FilmState& state);

}  // namespace gearfilm
