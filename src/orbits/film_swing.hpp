// The pair at rest on its films, and the mode in which it swings there, with what the grid leaves of errors.
//
// The mode on every second node tells the error, and gives the first guess; where that grid carries no film, the mode
// on half of all nodes, in steps longer by the root of two. Where the pair swings many times while oil
// crosses a contact, the films have no time to flow: they are stiff springs between the bodies.
#pragma once

#include <complex>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "dynamics/lubricated_pair.hpp"
#include "dynamics/pair_numerics.hpp"
#include "numerics/estimate.hpp"
#include "orbits/dynamic_stiffness.hpp"

namespace gearfilm {

/// The pair at the chosen position, its films in balance with the static force.
class RestingPair {
public:
  /// mesh: of contacts that are held. Throws SolveError where there are no such films. Collective.
  RestingPair(MeshModel mesh, const PairNumerics& numerics, const SharedDiscretisation& discretisation);

  LubricatedPair& pair() { return *pair_; }
  Vec state() const { return state_; }
  std::size_t contacts() const { return films_.size(); }
  double displacement() const { return H0_; }  ///< H_0 [-]
  /// Wider than that which was given, where a film had no room there.
  const SharedDiscretisation& discretisation() const { return discretisation_; }

private:
  MeshModel mesh_;
  SharedDiscretisation discretisation_;
  std::vector<std::unique_ptr<ContactFilm>> films_;
  std::optional<LubricatedPair> pair_;
  OwnedVec state_;
  double H0_ = 0.0;
};

/// The mode on a grid with steps that are longer by a ratio.
struct CoarserSwing {
  SwingingMode mode;
  double ratio = 2.0;
};

struct FilmSwing {
  SwingingMode mode;
  Steps steps;                            ///< of its grid
  std::optional<CoarserSwing> coarser{};  ///< nothing where no coarser grid has a mode

  /// |s|/U from which films are springs.
  static constexpr double stiff_from = 10.0;
  bool on_stiff_films() const { return mode.swings_in_passage > stiff_from; }
};

struct SwingWatch {
  Watcher watcher{};                                    ///< called every Krylov iteration
  std::function<void(RestingPair& rest)> on_coarser{};  ///< called with the coarser grid that has a mode, if any
};

/// The mode of the pair at rest. Throws SolveError where there is none. Collective.
FilmSwing film_swing(const MeshModel& mesh, const PairNumerics& numerics, RestingPair& rest, const SwingWatch& watch);

/// Frequency [Hz] and damping ratio of a mode, with their errors; nothing is known of these without a coarser grid
/// that has it.
struct SwingQuantities {
  double frequency = 0.0;
  std::optional<double> frequency_error{};
  double damping_ratio = 0.0;
  std::optional<double> damping_ratio_error{};

  /// What the damping ratio is at most, with the error of the grid.
  std::optional<double> damping_ratio_bound() const;
};
SwingQuantities quantities_of(const FilmSwing& swing, const Scales& scales);

/// The rates s of another mode of bodies on the same films.
struct ModeRates {
  std::complex<double> rate;
  std::optional<std::complex<double>> coarser{};  ///< on the coarser grid of the swing; nothing where it has none
  double time = 1.0;                              ///< over whose unit both are [s]
  double share = 1.0;                             ///< of the contacts in the energy of its strained parts
  double damping_without_films = 0.0;
};
SwingQuantities quantities_of(const FilmSwing& swing, const Scales& scales, const ModeRates& rates);

/// What is to be said of a mode on stiff films, its limit and what is known of the damping, or of one whose errors are
/// not known. Empty for others. dry_frequency: f_n [Hz].
std::string swing_remark(const FilmSwing& swing, const SwingQuantities& quantities, double dry_frequency);

}  // namespace gearfilm
