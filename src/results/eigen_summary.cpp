#include "results/eigen_summary.hpp"

#include <cmath>

#include "input/case_setup.hpp"
#include "orbits/dry_modes.hpp"

namespace gearfilm {

Summary dry_pair_summary(const CaseInput& problem) {
  const std::array<double, 2> base_radii = {problem.pair.line->base_radius_pinion(),
                                            problem.pair.line->base_radius_wheel()};
  const double k_el = mesh_after_leaving(problem).stiffness_si();
  const GearInertias inertias = inertias_of(problem);
  const auto [rigid, swinging] = dry_modes(k_el, base_radii, inertias);
  return {{"k_el", k_el},
          {"m_ge", *problem.pair.equivalent_mass},
          {"inertia_pinion", inertias.pinion},
          {"inertia_wheel", inertias.wheel},
          {"f_n", swinging.frequency},
          {"mode_shape", swinging.shape},
          {"rigid_frequency", rigid.frequency},
          {"rigid_mode_shape", rigid.shape}};
}

Summary damper_summary(const CaseInput& problem, double f_n) {
  const double zeta = problem.march.dry_damping_ratio.value_or(0.0);
  return {{"damping_ratio", zeta}, {"damped_frequency", f_n * std::sqrt(1.0 - zeta * zeta)}};
}

void add_swing(const FilmSwing& swing, const SwingFigures& figures, Summary& summary) {
  const auto known = [](const std::optional<double>& value) { return value ? Summary(*value) : Summary(); };
  summary["film_frequency"] = figures.frequency;
  summary["film_frequency_error"] = known(figures.frequency_error);
  summary["film_damping_ratio"] = figures.damping_ratio;
  summary["film_damping_ratio_error"] = known(figures.damping_ratio_error);
  if (swing.on_stiff_films()) summary["film_damping_ratio_bound"] = known(figures.damping_ratio_bound());
  summary["swings_in_passage"] = swing.mode.swings_in_passage;
  summary["swing_solutions"] = swing.mode.solutions;
  summary["swing_krylov_iterations"] = swing.mode.krylov_iterations;
}

}  // namespace gearfilm
