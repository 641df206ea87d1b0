#include "gearfilm/stationary_film.hpp"

#include "input/case_setup.hpp"
#include "interface/views.hpp"
#include "results/steady_result.hpp"

namespace gearfilm {

struct StationaryFilm::Solution {
  SteadyResult steady;
  Results results;
};

StationaryFilm::StationaryFilm(MPI_Comm comm, const Case& of) {
  const QuietErrors quiet;
  const CaseInput& input = of.input();
  const SteadyPosition position = steady_position(input);
  const Grid grid(comm, steady_grid(comm, input, position, widening_check(1, heated_points(input))));
  SteadyResult steady = solve_steady(grid, input, position, {});
  Results results(Results::Content{steady.summary});
  solution_ = std::make_shared<const Solution>(Solution{std::move(steady), std::move(results)});
}

const Results& StationaryFilm::results() const { return solution_->results; }
// It keeps the solution alive.
Film StationaryFilm::film() const {
  return film_of(std::shared_ptr<const ContactFilm>(solution_, solution_->steady.solved.film.get()));
}

}  // namespace gearfilm
