// Rows over a whole face, closer to one another where pressure or gap change abruptly.
//
// Between the places y_c of which each wants the step d_c, the step is
//   h(y) = min( d_m , min_c ( d_c + (g - 1) |y - y_c| ) )
// equidistributed, with a row at the ends and wherever the gap has a kink or a bend.
#pragma once

#include <cmath>
#include <vector>

#include "contact/face.hpp"
#include "grid/row_axis.hpp"

namespace gearfilm {

/// A place [a] and the step that it wants.
struct RowPlace {
  double y = 0.0;
  double step = 0.0;
};

struct RowGrading {
  double first = 0.06;                   ///< step at the ends of the face [a]
  double kink = 0.1;                     ///< at kinks of the gap
  double bend = 0.25;                    ///< where its curvature jumps
  double growth = 1.35;                  ///< g, of a step to the next
  double largest = 2.5;                  ///< d_m [a]
  std::vector<RowPlace> contact_ends{};  ///< where contacts end within the face; rows need not lie there
  Strip reached{-HUGE_VAL, HUGE_VAL};    ///< by contacts; ends, kinks and bends beyond it want no step of their own

  void lengthen(double factor);
};

/// Rows from -half_width to half_width [a] with P = 0 at both ends, or from Y = 0 where the lower edge is one of
/// symmetry. A row lies in Y = 0 and in each of the places within.
RowAxis graded_rows(double half_width, const std::vector<RowPlace>& within, const RowGrading& grading, Edge lower);
/// Rows over a face with its kinks and bends, in units of a [m].
RowAxis rows_over_face(const Face& face, const RowGrading& grading, double a, Edge lower);
/// Over half of it where both halves are alike.
RowAxis rows_over_face(const Face& face, const RowGrading& grading, double a);

}  // namespace gearfilm
