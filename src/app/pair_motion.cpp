#include "app/pair_motion.hpp"

#include <sstream>

#include "gearfilm/error.hpp"
#include "input/case_numerics.hpp"
#include "output/progress.hpp"

namespace gearfilm {
namespace {

/// Free oscillations in a mesh period from which on the forces of inertia are small beside those of the mesh.
constexpr double many_swings = 50.0;

/// Of a pair whose motion the program may choose; 0 of another.
double swings_in_mesh_period(const Case& problem) {
  const MarchCase& march = problem.march;
  const ParameterValues& values = problem.parameters;
  const bool free = problem.pair.equivalent_mass && march.model == MarchModel::dynamic &&
                    march.geometry == MeshGeometry::moving && !march.start_motion && !values.has("motion") &&
                    !values.has("ramp.to_rpm") && values.text("friction.in_motion") == "no" &&
                    !values.given("periodic.multipliers") && problem.search.order == 1;
  return free ? mesh_period(problem) / natural_period(problem) : 0.0;
}

}  // namespace

Case with_chosen_motion(MPI_Comm comm, const Case& problem) {
  const double swings = swings_in_mesh_period(problem);
  if (swings <= many_swings) return problem;
  std::ostringstream text;
  text.precision(3);
  text << "the pair swings " << swings
       << " times in a mesh period: its motion is computed without inertia (motion: quasi_static), which leaves out "
          "the swing after each entering contact and the multipliers; motion: dynamic computes them\n";
  petsc_check(PetscPrintf(comm, "%s", text.str().c_str()));
  return without_inertia(problem);
}

const char* word_of(PairMotion motion) { return motion == PairMotion::dynamic ? "dynamic" : "quasi_static"; }

void require_dynamic(const Case& problem, const std::string& command) {
  if (problem.march.motion == PairMotion::dynamic) return;
  throw InputError(problem.parameters.origin("motion") + ": 'motion' is quasi_static, but " + command +
                   " is for pairs that swing; set it to dynamic");
}

}  // namespace gearfilm
