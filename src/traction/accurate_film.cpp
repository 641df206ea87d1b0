#include "traction/accurate_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "film/validity.hpp"
#include "grid/domain.hpp"

namespace gearfilm {
namespace {

/// Goes on to the film that feels its heat and shear.
void couple(const ContactProblem& problem, SolvedContact& solved) {
  const TractionModel& model = *problem.traction;
  solved.bare = solved.result.quantities;
  solved.coupled = solve_coupled(*solved.film, problem.load, problem.solver, model, solved.result);
  solved.result = solved.coupled->film;
  solved.errors = grid_errors(*solved.film, problem.load, problem.solver, solved.result,
                              [&](ContactFilm& coarse, const StationaryResult& cold) {
                                return solve_coupled(coarse, problem.load, problem.solver, model, cold).film;
                              });
}

/// The shape in steps shorter by so much, as far as grids are chosen.
GridShape refined(const GridShape& shape, double factor) {
  GridShape fine = shape;
  fine.nx = std::max(shape.nx, std::min(nodes_along(shape.nx - 1, 1.0 / factor), most_nodes));
  const int ny = std::max(shape.ny(), std::min(nodes_across(shape.ny() - 1, 1.0 / factor), most_nodes));
  if (shape.row_axis.has_equal_steps() && ny > shape.ny()) fine.row_axis = shape.row_axis.with_whole_count(ny);
  return fine;
}

/// By how much steps are too long: 1 where they are not.
double too_long(const ContactProblem& problem, const std::optional<GridErrors>& errors, double accuracy) {
  const double most = problem.discretisation == FilmDiscretisation::fitted ? std::numbers::sqrt2 : 2.0;
  if (!errors) return most;
  const double excess = errors->left() / accuracy;
  return excess > 1.0 ? std::min(most, 1.1 * std::sqrt(excess)) : 1.0;
}

}  // namespace

SolvedContact solve_contact(const Grid& grid, const ContactProblem& problem) {
  SolvedContact solved;
  solved.film = std::make_unique<ContactFilm>(discretise(grid, problem.scales, problem.discretisation), problem.scales,
                                              problem.solver.multigrid);
  move_surfaces(*solved.film, problem.conditions);
  solved.result = located(problem.label, [&] { return solve_stationary(*solved.film, problem.load, problem.solver); });
  if (problem.traction && problem.traction->corrects_film()) {
    located(problem.label, [&] { couple(problem, solved); });
  } else {
    solved.errors = grid_errors(*solved.film, problem.load, problem.solver, solved.result);
  }
  check_validity(*solved.film, solved.result.quantities, problem.label);
  return solved;
}

SolvedContact solve_contact_accurately(const Grid& grid, const ContactProblem& problem, double accuracy) {
  SolvedContact solved = solve_contact(grid, problem);
  const double factor = too_long(problem, solved.errors, accuracy);
  return factor > 1.0 ? solve_contact(Grid(grid.comm(), refined(grid.shape(), factor)), problem) : std::move(solved);
}

Traction traction_of(const ContactProblem& problem, const SolvedContact& solved) {
  if (solved.coupled) return solved.coupled->traction;
  if (!problem.traction) return {};
  return located(problem.label, [&] { return traction(*problem.traction, *solved.film); });
}

}  // namespace gearfilm
