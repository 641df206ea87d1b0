// Films that follow what changes at once: displacements where contacts come, go or are moved, grids, flow.
#include <algorithm>
#include <cmath>

#include "dynamics/meshed_films.hpp"
#include "film/face_pressure.hpp"
#include "film/rescaled_hertz_pressure.hpp"
#include "gearfilm/error.hpp"
#include "mesh/dry_force.hpp"

namespace gearfilm {
namespace {

// Films that have rates d(rho H)/dT and oil rho H, at nodes of all contacts [-], change by an implicit step with
//   d(rho H)/dT = rate + shift (rho H - rho H before) .

/// What an ImplicitStep of this shift calls the mass before it.
std::vector<double> mass_before(std::vector<double> oil, const std::vector<double>& rates, double shift) {
  for (std::size_t n = 0; n < oil.size(); ++n) oil[n] -= rates[n] / shift;
  return oil;
}

/// The rates behind the step.
std::vector<double> rates_behind(std::vector<double> oil, const std::vector<double>& before,
                                 const std::vector<double>& rates, double shift) {
  for (std::size_t n = 0; n < oil.size(); ++n) oil[n] = rates[n] + shift * (oil[n] - before[n]);
  return oil;
}

}  // namespace

// One implicit step of the change alone: G = 0 at the new displacements with
// d(rho H)/dT = rate + (rho H - rho H before)/duration, so that no jump is no change. Where films cannot follow at
// once, part of the jump is held back as a gap first.
void MeshedFilms::follow(const std::map<int, double>& before, double duration) {
  constexpr double smallest_part = 1e-3;
  const double shift = 1.0 / duration;
  const Compliance compliance = mesh_.compliance(numbers(), T_);
  const std::vector<double> here = displacements();
  std::vector<double> there = here, held_back(here.size());
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const auto known = before.find(contacts_[k].number);
    if (known != before.end()) there[k] = known->second;
    held_back[k] = there[k] - here[k];
  }
  const std::vector<double> oil = oil_at(there);
  const std::vector<double> rates = values(field::rate);
  const std::vector<double> mass = mass_before(oil, rates, shift);
  const LoadCondition load = LoadCondition::displacement(motion_.H0(), compliance);
  const auto solved = [&](double part, const NewtonOptions& options) {
    const std::vector<ContactFilm*> films = present_films();
    for (std::size_t k = 0; k < films.size(); ++k) {
      ContactConditions conditions = films[k]->conditions();
      conditions.gap_offset += part * held_back[k];
      move_surfaces(*films[k], conditions);
    }
    FilmSolution moved{values(field::pressure), motion_.H0()};
    if (!StationaryNewton(films, options).solve(load, moved, ImplicitStep{shift, mass})) return false;
    set_values(field::pressure, moved.pressure);
    return true;
  };
  const std::vector<double> known = values(field::pressure);
  set_values(field::pressure, rescaled_pressures(there));
  double part = 1.0;
  if (solved(0.0, options_.steps.newton)) {
    part = 0.0;
  } else {
    set_values(field::pressure, known);
  }
  for (double step = 1.0; part > 0.0;) {
    const double next = std::max(0.0, part - step);
    if (solved(next, options_.steps.newton) || solved(next, options_.films.newton)) {
      part = next;
    } else if (step > smallest_part) {
      step *= 0.5;
    } else {
      const double largest = *std::ranges::max_element(held_back, {}, [](double jump) { return std::abs(jump); });
      throw SolveError(label(contacts_.front().number), ": the films do not follow a jump of H by ",
                       std::to_string(-largest));
    }
  }
  set_values(field::rate, rates_behind(oil_at(displacements()), oil, rates, shift));
}

// G = 0 with d(rho H)/dT = rate + shift (rho H - rho H of the interpolated pressures): at once with a shift so small
// that films do not feel it, or from that of a time step to there. All of these are states to go on from.
void MeshedFilms::adapt_pressures() {
  constexpr double unfelt = 1e-3, fall = 0.25;
  const std::vector<double> rates = values(field::rate), oil = oil_at(displacements());
  const LoadCondition load = LoadCondition::displacement(motion_.H0(), mesh_.compliance(numbers(), T_));
  const auto solved = [&](double shift, const NewtonOptions& options) {
    const std::vector<double> mass = mass_before(oil, rates, shift);
    FilmSolution films{values(field::pressure), motion_.H0()};
    if (!StationaryNewton(present_films(), options).solve(load, films, ImplicitStep{shift, mass})) return false;
    set_values(field::pressure, films.pressure);
    set_values(field::rate, rates_behind(oil_at(displacements()), oil, rates, shift));
    return true;
  };
  if (solved(unfelt, options_.films.newton)) return;
  double shift = 1.0 / options_.steps.dT;
  if (!solved(shift, options_.steps.newton)) {
    throw SolveError(label(contacts_.front().number) + ": no films have the rates of those of another grid");
  }
  while (shift > unfelt && solved(shift * fall, options_.steps.newton)) shift *= fall;
}

// By Reynolds' equation, in which the rate stands alone.
void MeshedFilms::adapt_rates() {
  if (!mesh_.corrects_films()) return;
  const std::vector<double> displaced = displacements();
  const std::vector<ContactFilm*> films = present_films();
  std::vector<double> rows(discretisation_->grid().local_size());
  for (std::size_t k = 0; k < films.size(); ++k) {
    const std::vector<double>& pressure = values_of(contacts_[k].fields, field::pressure);
    std::vector<double>& rate = values_of(contacts_[k].fields, field::rate);
    films[k]->residual(pressure, displaced[k], {rate, 1.0 / options_.steps.dT}, rows);
    for (std::size_t n = 0; n < rows.size(); ++n) rate[n] -= pressure[n] > 0.0 ? rows[n] : 0.0;
  }
}

std::vector<double> MeshedFilms::rescaled_pressures(const std::vector<double>& displaced) const {
  const std::vector<double> before = forces();
  DryContacts dry(DryForce(mesh_), mesh_, numbers(), T_);
  dry.stand_for(before, displaced);
  const std::vector<double> after = dry.forces(motion_.H0());
  std::vector<double> all;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    std::vector<double> own = values_of(contacts_[k].fields, field::pressure);
    if (before[k] > 0.0 && after[k] > 0.0) {
      const ContactConditions conditions = mesh_.contact(contacts_[k].number, T_).conditions;
      if (mesh_.scales.face_law) {
        own = rescaled_face_pressure(*discretisation_, mesh_.scales, conditions, before[k], after[k], own);
        all.insert(all.end(), own.begin(), own.end());
        continue;
      }
      const HertzContact ellipse = dry_contact(mesh_.scales, conditions, before[k]);
      own = rescaled_hertz_pressure(discretisation_->grid(), mesh_.scales, ellipse, std::cbrt(after[k] / before[k]),
                                    own, conditions.nearest.X);
    }
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

}  // namespace gearfilm
