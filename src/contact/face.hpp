// The flanks of a contact along the face, and what bounds them there.
//
// Gap of both flanks along the face before they are deformed, beside the parabola y^2/(2 R_y) of their crowning;
// y from the middle of the face, |y| <= F/2, positive where the gap opens:
//   l(y) = theta y + sum over the flanks of c (|y| - F/2 + d)_+^n/d^n - c_L ln(1 - (2 y/F)^2) + table
// with end reliefs of the amount c over the length d, n = 1 linear and n = 2 circular (a parabola). theta > 0 opens the
// end at +y. The logarithm is that of Lundberg's profile, cut off at 1e-9 of its argument. Assumption: edge breaks are
// not modelled; F ends where they begin.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace gearfilm {

/// Flanks that part by more than a fiftieth of the face touch at one end alone.
constexpr double largest_face_slope = 0.02;

struct EndRelief {
  double amount = 0.0;  ///< c at the end of the face [m]
  double length = 0.0;  ///< d [m]
  int power = 2;        ///< n
};

struct FaceGap {
  double slope = 0.0;                                            ///< theta [-]
  std::vector<EndRelief> reliefs{};                              ///< at both ends alike, of either flank
  double logarithmic = 0.0;                                      ///< c_L [m]
  std::vector<std::vector<std::pair<double, double>>> tables{};  ///< (y, gap) [m] of either flank, linear between
};

/// What the solids have at the ends of the face.
enum class EndFace : std::uint8_t {
  free,        ///< a plane without stress, at a right angle to the flank
  half_space,  ///< the solid goes on
  mirror       ///< a mirror image of the pressure times a factor
};

/// A body that ends with the face, and its part of the compliance of both, (1 - nu^2)/E over their sum.
struct EndingBody {
  double share = 0.5;
  double poisson_ratio = 0.3;
};

struct Face {
  double width = 0.0;  ///< F, of the narrower flank [m]
  FaceGap gap{};
  EndFace end = EndFace::free;
  std::vector<EndingBody> ending{};  ///< bodies that do not go on beyond the face
  double mirror_factor = 0.0;        ///< with EndFace::mirror

  /// l(y) [m].
  double operator()(double y) const;
  /// Whether the gap is its own mirror image in y = 0.
  bool symmetric() const;
  /// Where the slope of the gap jumps [m], within the face, increasing: dry pressure is infinite there.
  std::vector<double> kinks() const;
  /// Where its curvature jumps and its slope does not.
  std::vector<double> bends() const;
  /// Whether the gap is that of crowning and slope alone up to so far from a place [m].
  bool plain_around(double centre, double half_length) const;
};

}  // namespace gearfilm
