#include "dynamics/pair_state.hpp"

#include <algorithm>

#include "film/transfer.hpp"
#include "grid/remap.hpp"

namespace gearfilm {

PairState remapped(const PairState& state, MPI_Comm comm, const GridShape& shape) {
  if (state.shape == shape || state.films.empty()) return state;
  const Grid from(comm, state.shape), to(comm, shape);
  PairState result{state.motion, {}, shape};
  for (const ContactFields& film : state.films) {
    result.films.emplace_back();
    for (const auto& [name, values] : film) result.films.back()[name] = remapped(values, from, to);
  }
  return result;
}

PairState refined(const PairState& state, MPI_Comm comm, Coarsening along) {
  PairState result{state.motion, {}, state.shape};
  result.shape.nx = 2 * state.shape.nx - 1;
  if (along == Coarsening::both) result.shape.row_axis = state.shape.row_axis.refined();
  const Grid from(comm, state.shape), to(comm, result.shape), every_second = to.coarsened(along);
  Field<double> coarse(every_second), fine(to);
  for (const ContactFields& film : state.films) {
    result.films.emplace_back();
    for (const auto& [name, values] : film) {
      coarse.load(remapped(values, from, every_second));
      interpolate_cubic(every_second, to, coarse, fine);
      std::vector<double>& own = result.films.back()[name];
      own.resize(to.local_size());
      fine.store(own);
      const double smallest = field_named(name).smallest;
      for (double& value : own) value = std::max(smallest, value);
    }
  }
  return result;
}

}  // namespace gearfilm
