// Rows over a whole face, closer to one another where pressure or gap change abruptly.
//
// Between the places y_c of which each wants the step d_c, the step is
//   h(y) = min( d_m , min_c ( d_c + (g - 1) |y - y_c| ) )
// equidistributed, with a row in every place.
#pragma once

#include <vector>

#include "contact/face.hpp"
#include "grid/row_axis.hpp"

namespace gearfilm {

struct RowGrading {
  double first = 0.06;   ///< step at the ends of the face [a]
  double kink = 0.1;     ///< and at its kinks
  double growth = 1.35;  ///< g, of a step to the next
  double largest = 2.5;  ///< d_m [a]

  void lengthen(double factor) {
    first *= factor;
    kink *= factor;
    largest *= factor;
  }
};

/// Rows from -half_width to half_width [a] with P = 0 at both ends, or from Y = 0 where the lower edge is one of
/// symmetry. A row lies in Y = 0. kinks: increasing; those on the face count.
RowAxis graded_rows(double half_width, const std::vector<double>& kinks, const RowGrading& grading, Edge lower);
/// Rows over a face with its kinks, in units of a [m]; over half of it where both halves are alike.
RowAxis rows_over_face(const Face& face, const RowGrading& grading, double a);

}  // namespace gearfilm
