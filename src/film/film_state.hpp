// The film at every node: pressures, film thickness, and the oil properties that enter Reynolds' equation.
//
// The total pressure is the unknown: it deforms the solids and carries the load. The film pressure is that of the oil:
// it drives the flow, sets viscosity and density, and cavitates. Between smooth surfaces both are the same.
//
//   fluidity phi = F S/(eta lambda),  conductance xi_R = rho H^3 phi    (22) of doi 10.1016/j.triboint.2013.01.017
// between rough surfaces with their mean gap in what is carried and their conducting gap in xi_R (rough_gap.hpp),
// with the factors of flow_factors.hpp; all dimensionless, rho and eta relative to ambient. Derivatives are kept beside
// the values: the exact Jacobian and every coarser level of the preconditioner are made from them without evaluating
// the oil again.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/scales.hpp"
#include "film/flow_factors.hpp"
#include "film/rough_gap.hpp"
#include "grid/halo.hpp"

namespace gearfilm {

/// Weights of the nodes W, 0 and 1 of a face (face_flow.hpp).
struct FaceWeights {
  double w = 0.0, node_0 = 0.0, node_1 = 0.0;
};

struct FilmState {
  explicit FilmState(const Grid& grid)
      : total_pressure(grid),
        thickness(grid),
        density(grid),
        density_by_pressure(grid),
        fluidity(grid),
        log_fluidity(grid),
        log_fluidity_by_pressure(grid),
        entrained(grid),
        rate(grid),
        full_film(grid),
        row_scale(grid),
        ones(static_cast<std::size_t>(thickness.stride()), 1.0),
        zeros(ones.size(), 0.0) {
    entrained.fill(1.0);
  }

  /// Pressure of the oil in units of the Hertz pressure, on own nodes and ghosts.
  const Field<double>& film_pressure() const { return rough ? rough->film_pressure : total_pressure; }
  Field<double>& film_pressure() { return rough ? rough->film_pressure : total_pressure; }
  /// What oil fills between the surfaces.
  const Field<double>& mean_gap() const { return rough ? rough->mean : thickness; }

  Field<double> total_pressure;            ///< P
  Field<double> thickness;                 ///< H
  Field<double> density;                   ///< rho
  Field<double> density_by_pressure;       ///< d rho/dP
  Field<double> fluidity;                  ///< phi
  Field<double> log_fluidity;              ///< ln(phi lambda)
  Field<double> log_fluidity_by_pressure;  ///< d ln phi/dP
  Field<double> entrained;                 ///< U + W, with which the wedge carries oil
  Field<double> rate;                      ///< d(rho H)/dT of the squeeze term
  Field<double> full_film;                 ///< 1 where Reynolds' equation holds, 0 where P = 0 (cavitated, boundary)
  Field<double> row_scale;                 ///< d, the factor of P in the row of a node that is not full
  std::optional<Field<double>> across{};   ///< A, the conductance in y over that in x; absent, on all processes, where
                                           ///< it is 1 everywhere
  std::optional<Field<double>> heights{};  ///< q U, which the wedge carries of flanks whose heights travel
                                           ///< (carried_heights.hpp); absent on all processes where none do
  std::optional<RoughGap> rough{};         ///< of rough surfaces, on all processes
  FaceWeights of_rates{};                  ///< weights of rates in the wedge; none where rates are not accurate
  bool without_oil = false;                ///< all nodes are dry
  std::vector<double> ones;                ///< of a line with its ghosts, for what is 1 everywhere
  std::vector<double> zeros;               ///< and 0
};

/// All fields of a state but A, for what treats them alike (injection, gathering).
inline constexpr std::array<Field<double> FilmState::*, 11> state_fields = {&FilmState::total_pressure,
                                                                            &FilmState::thickness,
                                                                            &FilmState::density,
                                                                            &FilmState::density_by_pressure,
                                                                            &FilmState::fluidity,
                                                                            &FilmState::log_fluidity,
                                                                            &FilmState::log_fluidity_by_pressure,
                                                                            &FilmState::entrained,
                                                                            &FilmState::rate,
                                                                            &FilmState::full_film,
                                                                            &FilmState::row_scale};

enum class FlowDirection : std::uint8_t { along, across };

/// The fields of a state on one line of nodes, with their ghosts, for flow along the entrainment or across it. Loops
/// over smooth surfaces that know it need not read what is 1 or 0 there.
template <bool may_be_rough>
struct LineOfState {
  LineOfState(const FilmState& state, int i, FlowDirection direction = FlowDirection::along)
      : p(state.film_pressure().row(i)),
        h(state.mean_gap().row(i)),
        h_H(state.ones.data() + 1),
        g(h),
        g_H(h_H),
        slid(state.zeros.data() + 1),
        slid_H(slid),
        rho(state.density.row(i)),
        rho_p(state.density_by_pressure.row(i)),
        phi(state.fluidity.row(i)),
        f(state.log_fluidity.row(i)),
        f_p(state.log_fluidity_by_pressure.row(i)),
        entrained(state.entrained.row(i)),
        rate(state.rate.row(i)),
        heights(state.heights ? state.heights->row(i) : state.zeros.data() + 1),
        across(state.across ? state.across->row(i) : state.ones.data() + 1) {
    if (!may_be_rough || !state.rough) return;
    const RoughGap& gap = *state.rough;
    const bool along = direction == FlowDirection::along;
    h_H = gap.mean_by_gap.row(i);
    g = (along ? gap.along : gap.across).row(i);
    g_H = (along ? gap.along_by_gap : gap.across_by_gap).row(i);
    slid = gap.slid.row(i);
    slid_H = gap.slid_by_gap.row(i);
  }

  [[gnu::always_inline]] double mean_slope(int j) const { return may_be_rough ? h_H[j] : 1.0; }
  [[gnu::always_inline]] double conducting_slope(int j) const { return may_be_rough ? g_H[j] : 1.0; }
  [[gnu::always_inline]] static double sliding_part(const double* factor, const double* flow, int j) {
    return may_be_rough ? factor[j] * flow[j] : 0.0;
  }

  /// m = rho [h (U + W) + slid] + q U, what the wedge carries, with its derivatives by P and H.
  [[gnu::always_inline]] double carried(int j) const {
    return rho[j] * h[j] * entrained[j] + sliding_part(rho, slid, j) + (may_be_rough ? heights[j] : 0.0);
  }
  [[gnu::always_inline]] double carried_by_pressure(int j) const {
    return rho_p[j] * h[j] * entrained[j] + sliding_part(rho_p, slid, j);
  }
  [[gnu::always_inline]] double carried_by_thickness(int j) const {
    return rho[j] * entrained[j] * mean_slope(j) + sliding_part(rho, slid_H, j);
  }
  /// xi_R. A film H < 0 (met only inside an iteration) conducts nothing.
  [[gnu::always_inline]] double conductance(int j) const {
    const double film = g[j] > 0.0 ? g[j] : 0.0;
    return rho[j] * phi[j] * (film * film * film);
  }
  /// d xi_R/dP at constant H, and d xi_R/dH at constant P.
  [[gnu::always_inline]] double conductance_by_pressure(int j) const {
    const double film = g[j] > 0.0 ? g[j] : 0.0;
    return phi[j] * (film * film * film) * (rho_p[j] + rho[j] * f_p[j]);
  }
  [[gnu::always_inline]] double conductance_by_thickness(int j) const {
    const double film = g[j] > 0.0 ? g[j] : 0.0;
    return 3.0 * rho[j] * phi[j] * (film * film) * conducting_slope(j);
  }

  const double* p;              ///< of the oil
  const double *h, *h_H;        ///< gap that the oil fills, and its derivative by H
  const double *g, *g_H;        ///< conducting gap
  const double *slid, *slid_H;  ///< what sliding carries beside the entrainment
  const double *rho, *rho_p, *phi, *f, *f_p, *entrained, *rate, *heights, *across;
};

using StateLine = LineOfState<true>;

/// Oil properties of one contact in dimensionless form.
class FilmProperties {
public:
  explicit FilmProperties(const Scales& scales)
      : viscosity_(viscosity_evaluator(scales.oil)),
        density_(density_evaluator(scales.oil)),
        pressure_scale_(scales.pressure),
        inverse_lambda_(1.0 / scales.lambda) {}

  /// Fills density, fluidity and their derivatives from the pressure of the own nodes.
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

/// Exchanges what faces read from the neighbouring rows: pressure, film and oil, and A where it is not one.
void exchange_ghosts(const Halo& halo, FilmState& state);

}  // namespace gearfilm
