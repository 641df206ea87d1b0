// The states of a lubricated march, copied at every accepted step.
#pragma once

#include "pair_case.hpp"

namespace gearfilm {

/// One accepted state; compact arrays, one for each contact.
struct AcceptedState {
  double T = 0.0;
  double dT = 0.0;
  Motion motion;
  std::vector<int> numbers;
  std::vector<std::vector<double>> pressure;
  std::vector<std::vector<double>> mass;  ///< rho H
};

inline AcceptedState copy_of(const StepRecord& record, const std::vector<ActiveContact>& contacts) {
  AcceptedState state{record.T, record.dT, record.motion, {}, {}, {}};
  for (const ActiveContact& contact : contacts) {
    const FilmState& film = contact.film->state();
    const Grid& grid = contact.film->grid();
    std::vector<double> pressure(grid.local_size()), density(grid.local_size()), mass(grid.local_size());
    film.total_pressure.store(pressure);
    film.density.store(density);
    film.thickness.store(mass);
    for (std::size_t n = 0; n < mass.size(); ++n) mass[n] *= density[n];
    state.numbers.push_back(contact.number);
    state.pressure.push_back(std::move(pressure));
    state.mass.push_back(std::move(mass));
  }
  return state;
}

/// The march of a case up to T, the last three states of which are kept.
class AcceptedSteps {
public:
  AcceptedSteps(const CaseInput& problem, double T_end) : march(problem) {
    march.on_step = [this](const StepRecord& record, const std::vector<ActiveContact>& contacts) {
      earliest = std::move(before_last);
      before_last = std::move(last_but_one);
      last_but_one = std::move(last);
      last = copy_of(record, contacts);
    };
    march.start();
    march.run(T_end);
  }

  RecordedMarch march;
  AcceptedState earliest, before_last, last_but_one, last;
};

/// A system of its own for the contacts and the place of a state.
class PairAt {
public:
  PairAt(const RecordedMarch& march, const AcceptedState& state, int levels = 1) {
    MultigridOptions options = march.problem().numerics.solver.multigrid;
    options.levels = levels;
    options.precision = Precision::double_precision;  // exact products
    std::vector<ActiveContact> contacts;
    for (const int number : state.numbers) {
      films_.push_back(std::make_unique<ContactFilm>(march.discretisation(), march.problem().scales, options));
      contacts.push_back({number, films_.back().get()});
    }
    pair = std::make_unique<LubricatedPair>(march.mesh(), contacts);
    pair->place(state.T);
  }

  FilmSystem& system() const { return pair->system(); }
  const ContactFilm& film(std::size_t contact) const { return *films_[contact]; }

  OwnedVec vector(const std::vector<std::vector<double>>& fields, const Motion& motion) const {
    OwnedVec vec = system().create_state();
    for (std::size_t k = 0; k < fields.size(); ++k) system().set_field(vec, k, fields[k]);
    pair->set_motion(vec, motion);
    return vec;
  }

  std::unique_ptr<LubricatedPair> pair;

private:
  std::vector<std::unique_ptr<ContactFilm>> films_;
};

}  // namespace gearfilm
