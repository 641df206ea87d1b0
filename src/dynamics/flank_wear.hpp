// What both flanks of a tooth lose while it passes through the mesh, by place on the flank.
//
//   dV_i/dt = k_i p_a |u_s| dA at x, y of a contact  ->  flank i at  s = s_1 - x  or  s_2 + x ,  y archard.hpp
// s: length of the involute from its base circle. Volumes go to the places of a rectangular lattice, along it by linear
// weights, across it by the strip of the film's row; weights have the sum one: what all places lose is what the
// asperities rub off. Over a mesh period the contacts
// that there are at a time lose together what one tooth loses in its passage. Between two steps rates are taken to
// change in a straight line, as in the means of march_statistics.hpp.
#pragma once

#include <array>
#include <vector>

#include "dynamics/step_record.hpp"

namespace gearfilm {

/// Equidistant places along a flank, from `begin` to `end` of s, and across it, from -half_width to half_width [m].
struct FlankPlaces {
  double begin = 0.0, end = 0.0, half_width = 0.0;
  int along = 2, across = 2;

  double s(int k) const { return begin + (end - begin) * k / (along - 1); }
  double y(int j) const { return half_width * (2.0 * j / (across - 1) - 1.0); }
  /// Area of the flank that belongs to a place, half as much at an end [m^2].
  double area(int k, int j) const {
    const auto part = [](int n, int count) { return n == 0 || n == count - 1 ? 0.5 : 1.0; };
    return part(k, along) * (end - begin) / (along - 1) * part(j, across) * 2.0 * half_width / (across - 1);
  }
};

/// Volumes [m^3], [along][across].
using FlankVolumes = std::vector<double>;

class FlankWear {
public:
  /// The mesh, which must outlive it, has coefficients of wear; face_width [m]. Places go beyond the active flank by
  /// two half-widths of the reference contact.
  FlankWear(const MeshModel& mesh, double face_width, int along, int across);

  /// After every accepted step. Records that are replayed have no films: an error.
  void add(const StepRecord& record, const std::vector<ActiveContact>& contacts);
  /// What was lost since the last call, on all processes. Collective.
  std::array<FlankVolumes, 2> take(MPI_Comm comm);

  const FlankPlaces& places(std::size_t gear) const { return places_[gear]; }

private:
  void add_rates(const ActiveContact& contact, double T);

  const MeshModel& mesh_;
  std::array<FlankPlaces, 2> places_;
  std::array<FlankVolumes, 2> lost_, rate_, last_rate_;  ///< of this process
};

}  // namespace gearfilm
