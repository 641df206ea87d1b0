// The stresses below the film of one contact, as it goes on in time. Only reads the film.
//
// They are computed once the material has moved so far since they were computed last (StressModel::every); in between
// the numbers of the last time stand. After every event they are computed again, so that a march that goes on from a
// kept state has the same ones.
#pragma once

#include <optional>

#include "mesh/meshed_contact.hpp"
#include "traction/film_stress.hpp"

namespace gearfilm {

class StressRecorder {
public:
  explicit StressRecorder(StressModel model) : model_(std::move(model)) {}

  /// The stresses below the film at its present state, at time T. Collective.
  const ContactStress& observe(const ContactFilm& film, const MeshedContact& contact, double T,
                               std::span<const double> shear_stress);
  /// The next ones are computed whatever the way.
  void begin_anew() { last_.reset(); }

  /// Whether stresses were computed at T, and the sections below the film then, where they are kept
  /// (StressModel::keeps_sections).
  bool is_of(double T) const { return last_ && *last_ == T; }
  const SectionRecords& records() const { return records_; }

private:
  StressModel model_;
  std::optional<double> last_;
  SectionRecords records_{};
  ContactStress stress_{};
};

}  // namespace gearfilm
