// Stresses below a film, in the sections beneath some of its rows.
//
// The surfaces carry the total pressure and the shear stress of surface_loads.hpp, with the friction in the middle of
// the film and, by the gap h that the oil fills and its pressure p, (h/2) dp/dx. Depths are in units of the Hertz
// half-axis a of the reference contact.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fatigue/flank_history.hpp"
#include "film/contact_film.hpp"
#include "stress/largest_stresses.hpp"

namespace gearfilm {

/// Which stresses are to be computed.
struct StressModel {
  std::vector<double> depths{};  ///< [a]
  std::array<double, body_count> poisson_ratio{};
  bool whole_fields = false;    ///< where fields are written
  double every = 0.0;           ///< way of the material between two computations of a march [a]
  bool keeps_sections = false;  ///< sections of a march are kept for the flanks' histories
  // Of a march, where the history of a point of a flank must stay in one row.
  bool all_rows = false;      ///< stresses below rows over the whole face; else below the most loaded one
  double most_loaded = 0.0;   ///< Y of the row that carries most of the dry contact at rest [a]
  double row_distance = 0.0;  ///< no two of all rows are nearer to each other [a]
};

/// What the stresses of one body come to; SI.
struct BodyStress {
  double von_mises = 0.0;  ///< [Pa]
  double von_mises_depth = 0.0;
  double shear = 0.0;
  double shear_depth = 0.0;
  double orthogonal_shear = 0.0;
  double orthogonal_shear_depth = 0.0;
  double surface_tension = 0.0;
};

using ContactStress = std::array<BodyStress, body_count>;

/// Sections below a film, until the next ones of its discretisation are computed; by rows.
struct FilmSections {
  const RowStress* rows = nullptr;
  const std::vector<SectionStresses>* stresses = nullptr;  ///< [p_h], of own depths
  std::vector<StressProfiles> profiles;                    ///< [p_h]
};

/// The stored rows below which a march has stresses. On a wider grid all rows are the same and more at its edges.
std::vector<int> stress_rows(const StressModel& model, const RowAxis& axis);
/// Options for the sections below rows.
RowStressOptions row_options(const StressModel& model, const std::vector<int>& rows);

/// What a film does to its surfaces: its pressure, the oil's, and the gap that the oil fills.
struct LoadingFields {
  const Field<double>& total_pressure;
  const Field<double>& film_pressure;
  const Field<double>& gap;
};

/// Loads on both bodies below these fields; shear_stress as for a film.
SurfaceLoads loads_below(const Scales& scales, const Grid& grid, const LoadingFields& fields,
                         std::span<const double> shear_stress);
/// Loads on both bodies below the film that was evaluated last; shear_stress: of the own nodes [Pa], empty without
/// friction.
SurfaceLoads loads_below(const ContactFilm& film, std::span<const double> shear_stress);

/// The stored row that carries the largest load by unit length; of grids whose rows are mirrored the central one,
/// unless they reach over a face. Collective.
int most_loaded_row(const ContactFilm& film);

/// Below rows of the film that was evaluated last. Collective.
FilmSections film_sections(const StressModel& model, const ContactFilm& film, std::span<const double> shear_stress,
                           const std::vector<int>& rows);

/// A section on the first process, elsewhere nothing: component by component [depth][line] of each body.
struct WholeSection {
  std::vector<double> x, z;                            ///< [m]
  std::array<std::vector<Stress>, body_count> stress;  ///< [depth][line], in Pa
};

/// That of the first row. Collective.
WholeSection whole_section(const Scales& scales, const FilmSections& sections);

/// Von Mises stress in both bodies [Pa] below the own nodes, each at the depth where it is largest below some rows.
/// Collective.
std::array<std::vector<double>, body_count> von_mises_fields(const StressModel& model, const ContactFilm& film,
                                                             std::span<const double> shear_stress,
                                                             const std::vector<int>& rows);

/// The sections of a contact at xi as flanks' histories have them, of both bodies, by rows.
using SectionRecords = std::vector<std::array<SectionRecord, body_count>>;
SectionRecords section_records(const Scales& scales, const RowStress& rows,
                               const std::vector<SectionStresses>& stresses, double xi);

/// The largest values of all sections; in SI.
ContactStress contact_stress(const Scales& scales, const FilmSections& sections);

}  // namespace gearfilm
