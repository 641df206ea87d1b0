// The heat and the shear of a film that feels them, in time.
//
// After each time step the energy equation is solved for that step, and the film has the flow that its temperatures
// make, extrapolated to the next one. Among the fields of a contact the temperatures are beta (T - T_0), beside what
// they make of the flow.
#pragma once

#include "dynamics/film_process.hpp"

namespace gearfilm {

class HeatProcess final : public FilmProcess {
public:
  explicit HeatProcess(const TractionModel& model) : model_(model) {}

  void begin(ContactFilm& film, const LoadCondition& load, const SolverOptions& options,
             StationaryResult& found) override;
  void advance(ContactFilm& film, double dT) override;
  void save(const Grid& grid, ContactFields& fields) const override;
  void restore(ContactFilm& film, const ContactFields& fields) override;
  /// After restore(), of the temperatures as they are; else of the last step.
  std::shared_ptr<const Traction> traction(const ContactFilm& film) const override;

private:
  TractionModel model_;
  FilmHeat heat_;
  std::shared_ptr<const Traction> of_step_;  ///< null where there was none
};

}  // namespace gearfilm
