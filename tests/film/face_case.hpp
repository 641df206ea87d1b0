// Contacts over a whole face, and line contacts: solids, oil and load of the reference numbers of end effects.
//
// R_x 9 mm, F 14 mm, 4000 N, E' 226.3736 GPa, 0.04 Pa s, 2.2e-8 1/Pa, 10 m/s: a = 0.170 mm, p_h = 1.07 GPa. The numbers
// come from a program of its own, central, from -3 to 1.5 a.
#pragma once

#include "contact/line_contact.hpp"
#include "elasticity/row_contact.hpp"
#include "film_case.hpp"
#include "grid/graded_rows.hpp"

namespace gearfilm {

inline constexpr double face_width = 14e-3;
inline constexpr double face_load = 4000.0;

/// Ends of steel.
inline Face face_with(EndFace end, FaceGap gap = {}) {
  return {.width = face_width, .gap = std::move(gap), .end = end, .ending = {{.share = 1.0, .poisson_ratio = 0.3}}};
}

/// 10 um over 3 mm.
inline FaceGap relieved_ends(int power = 2) { return {.reliefs = {{.amount = 10e-6, .length = 3e-3, .power = power}}}; }

inline Scales scales_of_solids(const ContactSolids& solids, double load) {
  return make_scales(solids, {.viscosity = 0.04, .pressure_viscosity = 2.2e-8},
                     {.load = load, .entrainment_velocity = 10.0});
}

inline Scales face_scales(const Face& face, double radius_y = HUGE_VAL) {
  Scales scales = scales_of_solids({.radius_x = 9e-3,
                                    .radius_y = radius_y,
                                    .reduced_modulus = 226.3736e9,
                                    .face = std::make_shared<const Face>(face)},
                                   face_load);
  scales.face_law = std::make_shared<const FaceLaw>(face_law(scales, {0.9, 1.1}));
  return scales;
}

inline Scales line_scales(double line_load) {
  return scales_of_solids({.radius_x = 9e-3, .radius_y = HUGE_VAL, .reduced_modulus = 226.3736e9, .line = true},
                          line_load);
}

/// Rows over the face of some scales, all of them or those at Y >= 0.
inline RowAxis rows_of_face(const Scales& scales, const RowGrading& grading, Edge lower) {
  return rows_over_face(*scales.solids.face, grading, scales.length, lower);
}

/// Few rows, where these are not what is tested.
inline constexpr RowGrading few_rows{.first = 0.3, .kink = 0.8, .bend = 0.8, .growth = 2.0, .largest = 5.0};

/// From -3 to 1.5 a.
inline GridShape shape_over(const RowAxis& rows, int nx) { return {nx, -3.0, 1.5, rows}; }

}  // namespace gearfilm
