// What films do to the surfaces of both flanks while they pass over them, by place on the flank.
//
//   largest pressure, smallest film, highest temperature of the surface       over all times
//   E = int |(tau_m + tau_b) u_s| dt [J/m^2] ,  L = int |u_s| dt [m] while p > 0.01 p_h      a passage
// A node of a film at x, y lies on flank i at s = s_i(xi) -+ x, y (flank_path.hpp). Places are points along the flank
// and the rows of the film across it. Largest and smallest values go to the nearest point, sums to the two beside the
// node by linear weights, so that E over a flank is all that friction takes; what contacts do beyond the ends of a
// flank is kept apart. Between two steps rates change in a straight line (march_statistics.hpp). A passage is the mean
// over the mesh periods marched: in each of them contacts do together what one tooth feels.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "dynamics/step_record.hpp"
#include "fatigue/flank_path.hpp"

namespace gearfilm {

/// Fields over one flank, alike on all processes: [point][row of the whole domain], not a number where no contact was.
struct ContactMap {
  std::vector<double> s, xi, radius;  ///< points: from the base circle, of the contact there, of curvature [m]
  std::vector<double> y;              ///< rows [m]
  std::vector<double> pressure;       ///< largest [Pa]
  std::vector<double> film;           ///< smallest [m]
  std::vector<double> sliding;        ///< L [m]
  std::vector<double> energy;         ///< E [J/m^2]; empty without friction
  std::vector<double> temperature;    ///< highest [K]; empty where films have none
  double energy_beyond = 0.0;         ///< friction beyond both ends of the flank [J], of a line contact [J/m]
};

/// Pinion, wheel.
using ContactMapPair = std::array<ContactMap, 2>;

class ContactMaps {
public:
  /// The mesh must outlive it. period: T of a motion that is sought, after which maps begin again; absent: they never
  /// do.
  ContactMaps(const MeshModel& mesh, int points, std::optional<double> period = {});

  /// After every accepted step; steps that are replayed have no films, and change nothing. Collective.
  void add(const StepRecord& record, const std::vector<ActiveContact>& contacts);
  /// Nothing before any step. Collective.
  std::optional<ContactMapPair> maps() const;

  /// All that is known, alike on all processes, and on which rows. Collective.
  std::vector<double> values() const;
  const std::optional<Grid>& grid() const { return grid_; }
  /// Takes what values() gave, of films on this grid.
  void take(const std::vector<double>& values, const Grid& grid);

private:
  /// Fields over one flank on the rows of this process, [place][row]; the place behind the points is beyond both ends.
  struct Own {
    std::vector<double> pressure, film, temperature;                 ///< extremes [-], [-], [K]
    std::vector<double> energy, sliding, energy_rate, sliding_rate;  ///< sums, and as the last step ended
    std::vector<double> next_energy_rate, next_sliding_rate;         ///< as this step ends
    auto kept() { return std::array{&pressure, &film, &temperature, &energy, &sliding, &energy_rate, &sliding_rate}; }
    auto kept() const {
      return std::array{&pressure, &film, &temperature, &energy, &sliding, &energy_rate, &sliding_rate};
    }
  };
  /// A node along x on a flank: the nearest place, and the two that share sums.
  struct Along {
    std::size_t nearest, first, second;
    double of_second;
  };

  std::size_t places() const { return static_cast<std::size_t>(points_) + 1; }
  void lay_on(const Grid& grid);
  void begin_anew();
  void add_contact(const ActiveContact& contact, double T);
  Along along(std::size_t body, double s) const;
  std::vector<double> whole(const std::vector<double>& own) const;
  ContactMap map_of(std::size_t body, double periods) const;

  const MeshModel& mesh_;
  int points_;
  std::optional<double> period_;
  std::array<FlankPath, 2> paths_;
  std::optional<Grid> grid_;
  std::array<Own, 2> own_;
  double begin_ = 0.0, last_ = 0.0;  ///< T between which sums are
};

}  // namespace gearfilm
