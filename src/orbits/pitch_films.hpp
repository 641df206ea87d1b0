// Films near the pitch point in a motion that repeats after one mesh period. A pair that swings fast changes its films
// by as much as their half within a swing: where two grids have other phases of it, or other waves of film, a
// difference at the pitch point may be small by chance. The largest one within a quarter of a swing is not. Of pairs
// that swing less than ten times in a mesh period a fortieth of it counts, in which nothing else changes films.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/step_record.hpp"

namespace gearfilm {

/// A contact at a step.
struct PitchFilm {
  double time = 0.0;  ///< since it passed the pitch point, negative before
  ContactQuantities quantities;
};

/// Records contacts at every step from a quarter of a free swing (at most a fortieth of a mesh period) before the pitch
/// point to as long behind it; none of bodies in balance, or in motions that repeat after more than one mesh period.
class PitchFilmRecorder {
public:
  explicit PitchFilmRecorder(const MeshModel& mesh);

  void add(const StepRecord& record);
  /// The contacts of steps that end in (T_begin, T_end], sorted by the time since they passed the pitch point.
  std::vector<PitchFilm> within(double T_begin, double T_end) const;

private:
  struct Recorded {
    double T = 0.0;
    PitchFilm film;
  };
  const MeshModel& mesh_;
  double reach_ = 0.0;
  std::vector<Recorded> recorded_;
};

/// The relative change, other/films - 1, from the films of one motion to those of another at the same time since the
/// pitch point, with its sign, where its size is largest; of the quantity at this place in contact_quantities. Nothing
/// where both have no time in common.
std::optional<double> largest_relative_change(const std::vector<PitchFilm>& films, const std::vector<PitchFilm>& other,
                                              std::size_t quantity);

}  // namespace gearfilm
