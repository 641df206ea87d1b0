// What free end faces add to the deformation of a half-space.
//
// One end at s = 0, s the distance from it along the flank, z the depth along the end face. With pressures p' on the
// surface of the half-space, even in s, and q' likewise on the plane of the end face, there is no shear on either
// plane, and the normal stresses vanish on the end face and are p on the flank where
//   p' + S q' = p ,  q' + S p' = 0 ,   so  p' = (1 - S^2)^-1 p ,  u = (K + K_mirrored) p'
// (idea: Keer, Lee and Mura 1983, not looked up). S is the stress at depth z beneath unit pressure on a cell and its
// mirror image,
//   S = [f]/pi over the corners of the cell ,  rho^2 = x^2 + y^2 + z^2 ,
//   f(x, y) = -z x y/((y^2 + z^2) rho) + 2 nu atan(x y/(z rho)) + (1 - 2 nu) (atan(x/y) - atan(z x/(y rho)))
// Along X all are convolutions, and products of matrices wave number by wave number. Each of two ends is as if the
// other were not there: what they do to each other is of the order a/F.
//
// Most of what both ends add is the same everywhere: the body between them moves as a whole, by an amount that depends
// on its height and that the bending of a tooth contains. This part, the mean along the face beneath a uniform line
// load, is left out, so that contacts with and without end faces approach each other alike.
#pragma once

#include <vector>

#include "contact/face.hpp"
#include "grid/grid.hpp"

namespace gearfilm {

/// The ends of a grid's rows that are those of a face, and what the solids have there.
struct EndFaces {
  EndFace kind = EndFace::half_space;
  std::vector<EndingBody> bodies{};
  double mirror_factor = 0.0;

  bool act() const { return kind != EndFace::half_space; }
};

/// The end faces of a face.
EndFaces ends_of(const Face& face);

/// Compliance by target row, source row and distance in lines; rows of the stored axis, images included. Without C_h.
class EndFaceCompliance {
public:
  EndFaceCompliance(const GridShape& shape, const EndFaces& ends);

  double operator()(int i, int row, int source) const {
    return values_[(static_cast<std::size_t>(row) * rows_ + source) * lags_ + i];
  }

  int lags() const { return lags_; }

private:
  void leave_out_rigid_part(const GridShape& shape);

  int rows_;
  int lags_;
  std::vector<double> values_;
};

}  // namespace gearfilm
