#include "results/eigen_summary.hpp"

#include <cmath>

#include "input/case_setup.hpp"
#include "orbits/dry_modes.hpp"
#include "results/members.hpp"

namespace gearfilm {

namespace {

struct DryPair {
  explicit DryPair(const CaseInput& of)
      : problem(of), stiffness(mesh_after_leaving(of).stiffness_si()), inertias(inertias_of(of)) {
    const std::array<double, 2> radii = {of.pair.line->base_radius_pinion(), of.pair.line->base_radius_wheel()};
    modes = dry_modes(stiffness, radii, inertias);
  }

  const CaseInput& problem;
  double stiffness;
  GearInertias inertias;
  std::array<RotationalMode, 2> modes{};  ///< rigid rotation, and the swing
};

constexpr auto dry_members = std::to_array<Member<DryPair>>({
    {"k_el", "k_el", "N/m", "stiffness of the dry mesh under the static force, one contact at the pitch point",
     [](const DryPair& of) -> Summary { return of.stiffness; }},
    {"m_ge", "m_ge", "kg", "equivalent mass",
     [](const DryPair& of) -> Summary { return *of.problem.pair.equivalent_mass; }},
    {"inertia_pinion", "I_g1", "kg m^2", "moment of inertia of the pinion",
     [](const DryPair& of) -> Summary { return of.inertias.pinion; }},
    {"inertia_wheel", "I_g2", "kg m^2", "moment of inertia of the wheel",
     [](const DryPair& of) -> Summary { return of.inertias.wheel; }},
    {"f_n", "f_n", "Hz", "natural frequency of the dry pair",
     [](const DryPair& of) -> Summary { return of.modes[1].frequency; }},
    {"mode_shape", "", "-", "rotations of pinion and wheel in that mode, the larger one 1",
     [](const DryPair& of) -> Summary { return of.modes[1].shape; }},
    {"rigid_frequency", "", "Hz", "frequency of the rigid rotation: zero but for round-off",
     [](const DryPair& of) -> Summary { return of.modes[0].frequency; }},
    {"rigid_mode_shape", "", "-", "rotations of pinion and wheel in it",
     [](const DryPair& of) -> Summary { return of.modes[0].shape; }},
});

struct SwingOnFilms {
  const FilmSwing& swing;
  const SwingQuantities& quantities;
};

constexpr auto film_swing_members = std::to_array<Member<SwingOnFilms>>({
    {"film_frequency", "", "Hz", "frequency of the pair on its films",
     [](const SwingOnFilms& of) -> Summary { return of.quantities.frequency; }},
    {"film_frequency_error", "", "Hz", "its error; null where no coarser grid has a mode",
     [](const SwingOnFilms& of) -> Summary { return known(of.quantities.frequency_error); }},
    {"film_damping_ratio", "", "-", "damping ratio of the pair on its films",
     [](const SwingOnFilms& of) -> Summary { return of.quantities.damping_ratio; }},
    {"film_damping_ratio_error", "", "-", "its error, likewise",
     [](const SwingOnFilms& of) -> Summary { return known(of.quantities.damping_ratio_error); }},
    {"film_damping_ratio_bound", "", "-", "on stiff films: what the damping ratio is at most",
     [](const SwingOnFilms& of) -> Summary {
       return of.swing.on_stiff_films() ? known(of.quantities.damping_ratio_bound()) : absent();
     }},
    {"swings_in_passage", "", "-", "radians of the swing while oil crosses half a contact",
     [](const SwingOnFilms& of) -> Summary { return of.swing.mode.swings_in_passage; }},
    {"swing_solutions", "", "-", "linear solutions for the mode",
     [](const SwingOnFilms& of) -> Summary { return of.swing.mode.solutions; }},
    {"swing_krylov_iterations", "", "-", "iterations of the linear solver in all of them",
     [](const SwingOnFilms& of) -> Summary { return of.swing.mode.krylov_iterations; }},
});

}  // namespace

Summary dry_pair_summary(const CaseInput& problem) {
  Summary summary;
  add_members(dry_members, DryPair(problem), summary);
  return summary;
}

Summary damper_summary(const CaseInput& problem, double f_n) {
  const double zeta = problem.march.dry_damping_ratio.value_or(0.0);
  return {{"damping_ratio", zeta}, {"damped_frequency", f_n * std::sqrt(1.0 - zeta * zeta)}};
}

void add_swing(const FilmSwing& swing, const SwingQuantities& quantities, Summary& summary) {
  add_members(film_swing_members, SwingOnFilms{swing, quantities}, summary);
}

std::string modes_markdown() {
  return members_markdown("The dry pair of `eigen`", "Keys of its summary.", dry_members) +
         members_markdown("The pair on its films",
                          "Keys of the summary of `eigen`, beside `film_eigenvalues` [1/s], the eigenvalues of the "
                          "films by themselves that are nearest to zero.",
                          film_swing_members);
}

}  // namespace gearfilm
