// The film along one line of nodes across the entrainment, in SI units, as shear and heat need it.
#pragma once

#include <vector>

#include "film/contact_film.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

/// Velocities of both surfaces in every own row, in SI.
std::vector<SurfaceVelocities> row_velocities(const ContactFilm& film);

struct FilmLine {
  explicit FilmLine(const ContactFilm& film);

  /// Line i of the film at its present state.
  void load(int i);
  /// Its poiseuille, too.
  void load_flow(int i);

  std::vector<double> pressure;       ///< p [Pa], of the oil
  std::vector<double> thickness;      ///< h [m], between rough surfaces their mean gap
  std::vector<double> log_viscosity;  ///< ln(eta/1 Pa s) at the oil's reference temperature
  std::vector<double> density;        ///< rho/rho_0
  std::vector<double> gradient;       ///< dp/dx [Pa/m], central
  std::vector<double> poiseuille;     ///< mean velocity that pressure drives, as Reynolds' equation has it [m/s]
  std::vector<char> full_film;        ///< p > 0
  std::vector<SurfaceVelocities> velocities;

private:
  const ContactFilm& film_;
  ViscosityEvaluator viscosity_;
};

}  // namespace gearfilm
