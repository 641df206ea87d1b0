// Quantities of a film along the face: films, pressures and loads of its rows, the tilting moment of its pressure, and
// the oil that leaves at both ends.
#pragma once

#include <vector>

#include "film/contact_film.hpp"

namespace gearfilm {

/// Dimensionless; of the whole domain, mirror images included. Rows from -Y to +Y.
struct FaceQuantities {
  std::vector<double> Y;
  std::vector<double> smallest_film;     ///< of a row
  std::vector<double> central_film;      ///< of a row, at X = 0
  std::vector<double> largest_pressure;  ///< of a row
  std::vector<double> line_load;         ///< Int P dX of a row
  bool corners_carry_films = true;       ///< not at free ends of a face
  double tilting_moment = 0.0;           ///< Int Int P Y dX dY
  double side_flow_lower = 0.0;          ///< out of the end at -Y beside the contact (X > -1), in u_m h a rho_0
  double side_flow_upper = 0.0;

  /// The thinner film of both corners: beneath the edges themselves, where nothing is carried.
  double corner_film() const;
  /// The smallest film of rows that are farther from both ends than so much [a].
  double smallest_film_beyond(double distance) const;
  /// Y of the smallest film, of those that count, and of the largest pressure.
  double smallest_film_at() const;
  /// By how much the nearer film of the rows beside that of the smallest film exceeds it: what rows may hide.
  double film_between_rows() const;
  double largest_pressure_at() const;

private:
  int thinnest_row() const;
};

/// The quantities of the film that was evaluated last. Collective.
FaceQuantities face_quantities(const ContactFilm& film);

}  // namespace gearfilm
