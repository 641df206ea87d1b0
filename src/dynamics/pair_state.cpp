#include "gearfilm/dynamics/pair_state.hpp"

#include "gearfilm/ehl/refit.hpp"

namespace gearfilm {

PairState refitted(const PairState& state, MPI_Comm comm, const GridShape& shape) {
  if (state.shape == shape || state.films.empty()) return state;
  const Grid from(comm, state.shape), to(comm, shape);
  PairState result{state.motion, {}, shape};
  for (const ContactFields& film : state.films) {
    result.films.emplace_back();
    for (const auto& [name, values] : film) result.films.back()[name] = refitted(values, from, to);
  }
  return result;
}

}  // namespace gearfilm
