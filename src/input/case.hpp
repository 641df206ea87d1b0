// A case: what is to be computed, ready for the solvers.
#pragma once

#include <petscsys.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/scales.hpp"
#include "dynamics/pair_numerics.hpp"
#include "fatigue/fatigue_model.hpp"
#include "gear/gear_pair.hpp"
#include "gear/line_of_action.hpp"
#include "gear/teeth.hpp"
#include "input/case_train.hpp"
#include "input/continuation_options.hpp"
#include "input/face_laws.hpp"
#include "input/parameter_values.hpp"
#include "input/sweep_options.hpp"
#include "input/worn_flanks.hpp"
#include "mesh/prescribed_load.hpp"
#include "mesh/shaft_tilt.hpp"
#include "orbits/dry_modes.hpp"
#include "orbits/orbit_search.hpp"
#include "rating/rating_model.hpp"
#include "traction/film_stress.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

enum class CaseKind { gear_pair, contact };
enum class MarchModel { dynamic, simplified, quasistatic, dry };
/// How the bodies of a pair move (MarchModel::dynamic): by their inertia, or in balance with all contacts at every
/// moment.
enum class PairMotion { dynamic, quasi_static };

/// The gears of a pair, and how they turn.
struct PairCase {
  std::optional<SpurGearPair> gears;  ///< absent for a bare contact
  std::optional<LineOfAction> line;
  Teeth teeth;
  std::shared_ptr<const std::array<Topography, 2>> topography;  ///< heights that films follow; none: smooth
  std::array<double, 2> shortest_waves{HUGE_VAL, HUGE_VAL};     ///< of them, along the flank and across [m]
  double stiffness = 0.0;                 ///< of the dry mesh at the pitch point (static_mesh.hpp) [-]
  double pinion_speed = 0.0;              ///< Omega_1 [rad/s]
  double torque = 0.0;                    ///< T_g1 on the pinion [N m]
  double tooth_force = 0.0;               ///< T_g1/R_b1 [N]
  std::optional<double> equivalent_mass;  ///< m_ge [kg]; absent for a pair without vibration
  std::optional<GearInertias> inertias;   ///< absent where the mass itself is given
  std::optional<TrainCase> train;         ///< absent: on rigid supports, and joined to nothing
  std::optional<ShaftTilt> tilt;          ///< absent: no gear is on two bearings at a distance
};

/// A stationary contact.
struct SteadyCase {
  double position = 0.0;    ///< xi [m]; zero for a bare contact
  double load_ratio = 1.0;  ///< its force over w* [-]
};

/// The dry pair turned slowly.
struct StaticCase {
  std::vector<double> load_ratios;  ///< over the static force
  int positions = 0;                ///< in a mesh period
};

/// A march in time; of a gear pair only.
struct MarchCase {
  MarchModel model = MarchModel::dynamic;
  PairMotion motion = PairMotion::dynamic;
  MeshGeometry geometry = MeshGeometry::moving;
  std::optional<PrescribedLoad> load;  ///< of the models simplified and quasistatic
  double mesh_periods = 0.0;
  SpeedCourse course{};                          ///< of `transient`
  std::optional<ErrorTolerance> step_tolerance;  ///< of `transient`
  double start_position = 0.0;                   ///< xi of a contact at T = 0 [m]
  std::optional<Motion> start_motion;            ///< absent: at rest
  std::optional<double> snapshot_interval;  ///< mesh periods between stored fields; 0: none; absent: by the command
  std::optional<double> dry_damping_ratio;  ///< zeta of the dry model; absent: by the command
  std::optional<double> spectrum_periods;   ///< mesh periods at a march's end whose spectrum is taken
};

/// The search for a periodic state.
struct SearchCase {
  PeriodicOptions options;
  bool with_multipliers = true;
  bool multipliers_on_own_grid = false;
  int order = 1;        ///< mesh periods, or patterns of the teeth, after which it repeats
  int max_pattern = 1;  ///< mesh periods after which the same teeth meet again, at most
};

/// Natural modes.
struct ModesCase {
  int count = 0;          ///< eigenvalues of the pair on its films to compute
  bool of_orbit = false;  ///< multipliers of the periodic state too
  int orbit_periods = 0;  ///< mesh periods for them
};

/// Flanks that wear over many revolutions.
struct WearCase {
  std::optional<double> cycles;           ///< revolutions of the pinion
  double largest_step = 0.0;              ///< depth over the roughness, from one profile to the next
  int points = 0;                         ///< places along a flank
  std::optional<double> final_roughness;  ///< of both flanks together, run in [m]
  std::optional<double> running_in_work;  ///< of asperities on the area of a flank, in which it runs in [J/m^2]
};

/// How a run is conducted; no part of its results.
struct RunCase {
  bool restart = false;              ///< go on where the run stopped
  std::optional<double> time_limit;  ///< [s] of wall-clock time
  bool keep_checkpoint = false;      ///< when the run is complete
  bool all_processes = false;        ///< even where fewer are as fast
  std::filesystem::path directory;   ///< of the results
};

struct CaseInput {
  std::string name;
  CaseKind kind = CaseKind::gear_pair;
  PairCase pair;
  std::optional<TractionModel> traction;      ///< absent: no friction is computed
  std::optional<double> roughness;            ///< of both flanks together [m]
  std::optional<WearCoefficients> wear;       ///< absent: no wear is computed
  std::optional<StressModel> stress;          ///< absent: no stresses below films are computed
  std::optional<FatigueModel> fatigue;        ///< absent: fatigue of flanks is not judged
  std::shared_ptr<const RatingModel> rating;  ///< null: the pair is not rated
  std::optional<ThermalOil> thermal_oil;      ///< absent: how its viscosity falls with temperature is not known
  Scales scales;  ///< of the reference contact: the pitch point of a gear pair, or the bare contact
  std::shared_ptr<FaceLaws> face_laws;  ///< of this case and all that are made from it
  PairNumerics numerics;
  SteadyCase steady;
  StaticCase statics;
  MarchCase march;
  SearchCase search;
  SweepOptions sweep;
  ContinuationCase continuation;
  ModesCase modes;
  WearCase wearing;
  RunCase run;
  ParameterValues parameters;  ///< what was read; parameters.echo() goes into the results

  bool dry() const { return march.model == MarchModel::dry; }
};

/// Builds the case from a complete set of values. Throws InputError for values that do not fit together: a pair that
/// cannot mesh, masses or moduli given twice or by half, a position off the path of contact.
CaseInput make_case(const ParameterValues& values);

/// Builds another case of a pair, from values that mostly are those of the given one, whose face laws it shares.
CaseInput make_case_like(const CaseInput& given, const ParameterValues& values, const WornFlanks& worn = {});

/// Reads a case file under the present command line. Collective; throws InputError on all ranks alike.
CaseInput read_case(MPI_Comm comm, const std::string& file);

}  // namespace gearfilm
