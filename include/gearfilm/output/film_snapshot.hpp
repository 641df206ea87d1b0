// The fields of all contacts at one time, in memory.
#pragma once

#include <vector>

#include "gearfilm/dynamics/step_record.hpp"
#include "gearfilm/ehl/field.hpp"

namespace gearfilm {

/// Dimensionless fields of one contact.
struct ContactSnapshot {
  int contact = 0;
  double position = 0.0;  ///< xi [m]
  Field<double> pressure;
  Field<double> film;
};

struct FilmSnapshot {
  double T = 0.0;
  std::vector<ContactSnapshot> contacts;
};

/// Copies the fields of a step.
inline FilmSnapshot film_snapshot(const StepRecord& record, const std::vector<LiveContact>& contacts) {
  FilmSnapshot snapshot{record.T, {}};
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    snapshot.contacts.push_back(
        {contacts[k].contact, record.contacts[k].position, contacts[k].film->pressure(), contacts[k].film->film()});
  }
  return snapshot;
}

}  // namespace gearfilm
