// The fields of all contacts at one time, in memory.
#pragma once

#include <string>
#include <vector>

#include "dynamics/step_record.hpp"
#include "grid/field.hpp"

namespace gearfilm {

/// A dimensionless field and its name (contact_fields.hpp).
struct NamedField {
  std::string name;
  Field<double> values;
};

/// The fields of one contact, in the order in which they are written.
struct ContactSnapshot {
  int number = 0;
  double position = 0.0;  ///< xi [m]
  std::vector<NamedField> fields;
};

struct FilmSnapshot {
  double T = 0.0;
  std::vector<ContactSnapshot> contacts;
  GridShape shape{};         ///< of the grid that they are on
  bool of_sections = false;  ///< no result: for stresses below the films (section_replay.hpp)
};

/// The fields that follow from a film (field::pressure, thickness, traction), of friction and heat those that there
/// are; null without friction.
std::vector<NamedField> film_fields(const ContactFilm& film, const TractionFields* traction);
/// Fields of stresses below a film, where a model asks for them; with the sections below some rows. Collective.
std::vector<NamedField> stress_fields(const std::optional<StressModel>& model, const ContactFilm& film,
                                      const TractionFields* traction, const std::vector<int>& rows);

/// Copies the fields of a step that have a dataset in the results, and computes those of friction and heat. Collective.
FilmSnapshot film_snapshot(const MeshModel& mesh, const StepRecord& record, const std::vector<ActiveContact>& contacts);

}  // namespace gearfilm
