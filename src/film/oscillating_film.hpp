// The film linearised about a state at rest, oscillating as exp(s T) with complex s:
//   (A + s B) p + (a + s b) H_0 ,      A = dG/dP ,  a = dG/dH ,  B, b: the same of rho H at full nodes
// and one relaxation of it, smoother.hpp. Oil carries away what film it was given at the inlet, in waves of the
// length 2 pi U/|Im s|. Where conductance is small the operator nearly vanishes on them; a real shift, of whatever
// size, does not, so that nothing made for time steps stands for it there.
// Arrays are compact, [real parts, imaginary parts]: 2 nx*y_count values of this process.
#pragma once

#include <complex>
#include <memory>
#include <span>

#include "film/discretisation.hpp"
#include "film/film_state.hpp"

namespace gearfilm {

class OscillatingFilm {
public:
  /// The discretisation must outlive the film.
  explicit OscillatingFilm(Discretisation& discretisation);
  ~OscillatingFilm();

  // Collective, all of them.

  /// Linearises about a state with ghosts and full-film mask.
  void update(const FilmState& state, std::complex<double> s);
  /// rows = (A + s B) change.
  void multiply(std::span<const double> change, std::span<double> rows);
  /// column = a + s b.
  void displacement_column(std::span<double> column);
  /// change = one damped line relaxation of (A + s B) change = rows from zero.
  void relax(std::span<const double> rows, std::span<double> change);

private:
  struct Work;  ///< stencil, smoother and fields
  const Discretisation& discretisation_;
  std::unique_ptr<Work> work_;
};

}  // namespace gearfilm
