// The dry contact along a whole face, row by row.
//
// The pressure of row l is a semi-ellipse of the half-width s_l that carries the load w_l by unit length,
//   P(X, Y_l) = 2 w_l/(pi s_l) (1 - X^2/s_l^2)^(1/2) ,
// and the gap is closed in the middle and at the edges of every loaded row,
//   l(Y) + D Y^2/2 - c + u(0, Y) = 0 ,   u(0, Y) - u(s, Y) = s^2/(2 Rbar) ,   w >= 0 ,   sum_l w_l (cell of l) = F ,
// with the deformation u of all rows and of the ends of the face (there alike across a row). The pressure of an elastic
// ellipse, and that of an endless line, have this form: there the equations are exact but for the steps of rows.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "contact/face_law.hpp"
#include "contact/scales.hpp"
#include "elasticity/end_faces.hpp"
#include "grid/graded_rows.hpp"

namespace gearfilm {

/// Where a dry contact ends within the face.
struct ContactEnd {
  double y = 0.0;         ///< Y
  double widening = 0.0;  ///< |d(s^2)/dY| there, of its half-width s
};

class RowContact {
public:
  /// For the scales' face; rows over the whole face or half of it.
  RowContact(const Scales& scales, const RowAxis& rows);
  /// Adds what the ends of the face give way, from that of a grid of such rows.
  void add_ends(const EndFaceCompliance& ends, double h_x);

  /// The contact under a force at a radius, from the one that was solved last, until half-widths change by less than
  /// `settled` of the face's. Throws SolveError where it is not found.
  FaceContact solve(double force, double relative_radius, double settled = 1e-6);
  /// Lets the next one begin as the first did.
  void begin_anew();
  /// The smallest gap of the rows.
  double nearest() const { return *std::ranges::min_element(gaps_); }
  /// Loads by unit length of the rows that were solved last.
  const std::vector<double>& loads() const { return loads_; }
  /// Their half-widths.
  const std::vector<double>& half_widths() const { return half_widths_; }
  /// How much of the face they are together.
  double loaded_width() const;
  /// Y of the row that carries most of them, off the ends.
  double most_loaded_place() const;
  /// Where it ends within the face: over half of the face those at Y > 0.
  std::vector<ContactEnd> ends_within() const;
  /// From the last row without load below it to the first one above it, and `a` beyond both.
  Strip reached() const;

private:
  struct Place {
    double y, lower, upper;  ///< of a row and its cell, in the whole domain
    int stored;
  };

  void find_influence();
  /// Loads of the rows that carry a force at their half-widths, and the approach.
  double balance(double force);
  /// Goes a share of the way to the half-widths at which the gap of each row is closed at its edges; returns by how
  /// much those differ from the former ones.
  double follow_edges(double force, double approach, double relative_radius, double share);
  /// Loaded rows that are not beside an end; all loaded ones where there are no others.
  std::vector<int> counting_rows() const;
  FaceContact found(double force, double approach) const;
  /// values: work space for the nodes of a quadrature.
  static double influence(double at_x, double at_y, const Place& source, bool own, double s, std::span<double> values);

  const RowAxis rows_;
  double C_h_;
  std::vector<double> gaps_;     ///< of stored rows
  std::vector<double> weights_;  ///< of stored rows, images included
  std::vector<Place> whole_;
  std::vector<double> end_influence_;  ///< [target][source], of unit load by length
  std::vector<double> loads_, half_widths_;
  std::vector<bool> loaded_;
  std::vector<double> middle_, edge_;  ///< u of unit loads in the middle and at the edge of a row, [target][source]
};

/// Gradings of rows that tell how the load is spread over the scales' face, and of rows for numbers of its contacts.
RowGrading coarse_grading(const Scales& scales);
RowGrading fine_grading(const Scales& scales);

/// Rows for the dry contacts of a face, and what its ends give way beneath them.
class FaceRows {
public:
  FaceRows(const Face& face, const RowGrading& grading, double a);

  /// The dry contact along the scales' face, which has the same ends and kinks as that of the rows.
  RowContact contact(const Scales& scales) const;

private:
  RowAxis rows_;
  std::optional<EndFaceCompliance> ends_;
  double h_x_;
};

/// The part of a face that dry contacts under several forces load, in units of `a`.
struct LoadedFace {
  Strip reached;                 ///< under the largest force, and `a` beyond
  std::vector<ContactEnd> ends;  ///< within the face, under each force; at both sides where these are alike
};

/// Solves the dry contact along the scales' face for each of the forces [F by the scales], the largest first, on rows
/// of this grading, and tells where it is loaded. What free ends give way is left out. Throws SolveError.
LoadedFace loaded_face(const Scales& scales, std::span<const double> forces, const RowGrading& grading);

/// Y [a] of the row that carries most by unit length of the dry contact along the scales' face, under a force [-] at a
/// radius; rows beside an end do not count where others are loaded. Throws SolveError.
double most_loaded_place(const Scales& scales, double force, double relative_radius);

/// The law of the scales' face for forces around the static one, at radii between two.
FaceLaw face_law(const Scales& scales, std::array<double, 2> relative_radii);

}  // namespace gearfilm
