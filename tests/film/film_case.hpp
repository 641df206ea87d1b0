// What the film tests share: the contacts they solve, fields by formula, and comparisons across processes.
//
// Every test is collective on PETSC_COMM_WORLD. "Whole" arrays hold all stored nodes on every process, index i*rows +
// row.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "gear/line_of_action.hpp"
#include "solver/stationary.hpp"
#include "table3.hpp"

namespace gearfilm {

/// A contact and the domain on which its film is computed.
struct FilmCase {
  Scales scales;
  Domain domain;

  GridShape shape(int nx, int ny, Edge lower = Edge::symmetry) const {
    return grid_shape(domain, scales.hertz.ellipticity, nx, ny, lower);
  }
};

/// Pitch point of Table 3 (tests/unit/table3.hpp).
inline FilmCase table3_pitch() {
  const LineOfAction line(table3::gear_pair());
  const Scales scales = make_scales({.radius_x = line.radius_x(0.0),
                                     .radius_y = line.radius_y(),
                                     .reduced_modulus = reduced_modulus(206e9, 0.3, 206e9, 0.3)},
                                    {.viscosity = 0.04, .pressure_viscosity = 2.2e-8},
                                    {.load = table3::pinion_torque / line.base_radius_pinion(),
                                     .entrainment_velocity = line.entrainment_velocity(0.0, table3::pinion_speed)});
  return {scales, paper_domain(2400.0)};
}

/// Contact of the solids and oil of Table 3 with R_y, load and velocity chosen for the Moes groups M, L, D.
inline FilmCase moes_contact(double M, double L, double D) {
  const FilmCase pitch = table3_pitch();
  ContactSolids solids = pitch.scales.solids;
  solids.radius_y = solids.radius_x / D;
  const Lubricant oil = pitch.scales.oil;
  return {make_scales(solids, oil, operation_for_moes(solids, oil, M, L)), paper_domain(M)};
}

/// "steady_circular_definition" of tests/reference/table3.json.
inline FilmCase circular_contact() {
  const auto& definition = table3::reference().at("steady_circular_definition");
  const ContactSolids solids{
      .radius_x = definition.at("R_x"), .radius_y = definition.at("R_y"), .reduced_modulus = definition.at("E_prime")};
  const Lubricant oil{.viscosity = definition.at("eta_0"), .pressure_viscosity = definition.at("alpha_B")};
  return {make_scales(solids, oil, operation_for_moes(solids, oil, 20.0, 10.0)), paper_domain(20.0)};
}

/// The stationary film of a case, from nothing.
struct SolvedFilm {
  SolvedFilm(MPI_Comm comm, const FilmCase& film_case, int nx, int ny, const SolverOptions& options = {},
             Edge lower = Edge::symmetry, FilmDiscretisation by = FilmDiscretisation::fitted)
      : SolvedFilm(comm, film_case.scales, film_case.shape(nx, ny, lower), options, by) {}

  SolvedFilm(MPI_Comm comm, const Scales& scales, const GridShape& shape, const SolverOptions& options = {},
             FilmDiscretisation by = FilmDiscretisation::fitted)
      : grid(comm, shape),
        film(discretise(grid, scales, by), scales, options.multigrid),
        result(solve_stationary(film, LoadCondition::force(scales.static_force), options)) {}

  Grid grid;
  ContactFilm film;
  StationaryResult result;
};

/// field = f(X, Y) on the own nodes.
template <class Real, class Function>
void fill(const Grid& grid, Field<Real>& field, Function f) {
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.y_count(); ++j) field.row(i)[j] = static_cast<Real>(f(grid.x(i), grid.y(j)));
  }
}

/// The same value for every own row.
inline std::vector<double> in_all_rows(const Grid& grid, double value) {
  return std::vector<double>(static_cast<std::size_t>(grid.y_count()), value);
}

inline double maximum(double value) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  return value;
}

/// All nodes of a compact array on every process of the grid.
inline std::vector<double> whole_of(const Grid& grid, const std::vector<double>& compact) {
  std::vector<double> whole(static_cast<std::size_t>(grid.nx()) * grid.rows(), 0.0);
  for (int i = 0; i < grid.nx(); ++i) {
    std::copy_n(compact.data() + static_cast<std::size_t>(i) * grid.y_count(), grid.y_count(),
                whole.data() + static_cast<std::size_t>(i) * grid.rows() + grid.y_begin());
  }
  MPI_Allreduce(MPI_IN_PLACE, whole.data(), static_cast<int>(whole.size()), MPI_DOUBLE, MPI_SUM, grid.comm());
  return whole;
}

inline std::vector<double> whole_of(const Grid& grid, const Field<double>& field) {
  std::vector<double> compact(grid.local_size());
  field.store(compact);
  return whole_of(grid, compact);
}

inline std::vector<double> own_part(const Grid& grid, const std::vector<double>& whole) {
  std::vector<double> compact(grid.local_size());
  for (int i = 0; i < grid.nx(); ++i) {
    std::copy_n(whole.data() + static_cast<std::size_t>(i) * grid.rows() + grid.y_begin(), grid.y_count(),
                compact.data() + static_cast<std::size_t>(i) * grid.y_count());
  }
  return compact;
}

/// A contact away from the pitch, so that nothing is one that could be forgotten.
inline ContactConditions away_from_pitch() {
  FlankModification relieved;
  relieved.tip = {1e-6, 4e-3, ReliefShape::parabolic};
  const LocalProfile local{std::make_shared<const std::array<Flank, 2>>(
                               std::array<Flank, 2>{Flank(relieved, 5e-3, 20e-3), Flank({}, 5e-3, 25e-3)}),
                           {17e-3, 21e-3},
                           {39.5e-3, 60.6e-3}};
  ContactConditions conditions{.relative_radius = 0.9, .entrainment = 1.1, .gap_offset = 0.02, .local = local};
  conditions.nearest = nearest_point(table3_pitch().scales, conditions);
  return conditions;
}

/// Film of Table 3 away from the pitch, pressure whole; the same on every process whatever their number: the first
/// one's solution of the problem alone.
inline FilmSolution film_away_from_pitch(int nx, int ny) {
  const FilmCase pitch = table3_pitch();
  const Grid grid(PETSC_COMM_SELF, pitch.shape(nx, ny));
  ContactFilm film(discretise(grid, pitch.scales), pitch.scales, MultigridOptions{});
  move_surfaces(film, away_from_pitch());
  FilmSolution solution =
      solve_stationary(film, LoadCondition::force(pitch.scales.static_force), SolverOptions{}).solution;
  MPI_Bcast(solution.pressure.data(), static_cast<int>(solution.pressure.size()), MPI_DOUBLE, 0, PETSC_COMM_WORLD);
  MPI_Bcast(&solution.H0, 1, MPI_DOUBLE, 0, PETSC_COMM_WORLD);
  return solution;
}

inline double largest(const std::vector<double>& values) {
  double top = 0.0;
  for (const double value : values) top = std::max(top, std::abs(value));
  return top;
}

/// Largest difference over the largest value of `expected`; whole arrays.
inline double relative_difference(const std::vector<double>& computed, const std::vector<double>& expected) {
  double difference = 0.0;
  for (std::size_t n = 0; n < expected.size(); ++n)
    difference = std::max(difference, std::abs(computed[n] - expected[n]));
  return difference / largest(expected);
}

/// A field of all rows and that of the rows at Y >= 0 are the same but for so much of its largest value; whole arrays.
inline void expect_whole_is_half(const Grid& all, const std::vector<double>& computed, const Grid& half,
                                 const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(all.rows(), half.ny());
  std::vector<double> unfolded(computed.size());
  for (int i = 0; i < all.nx(); ++i) {
    for (int row = 0; row < all.rows(); ++row) {
      unfolded[i * all.rows() + row] = expected[i * half.rows() + half.row_axis().stored_row(row)];
    }
  }
  EXPECT_LT(relative_difference(computed, unfolded), tolerance);
}

/// A reproducible white noise in [-1, 1] over the nodes, the same on any number of processes.
inline double noise(int i, int row, unsigned seed = 0) {
  unsigned h =
      374761393U * static_cast<unsigned>(i) + 668265263U * static_cast<unsigned>(row) + 2246822519U * seed + 1U;
  for (int round = 0; round < 3; ++round) h = (h ^ (h >> 15)) * 2654435761U;
  return 2.0 * (h / 4294967296.0) - 1.0;
}

/// Compares an observed order with an entry of tests/reference/expected_rates.json.
inline void expect_rate(const std::string& name, double observed) {
  static const nlohmann::json rates =
      nlohmann::json::parse(std::ifstream(std::string(GEARFILM_REFERENCE_DIR) + "/expected_rates.json"));
  const double expected = rates.at(name).at("rate"), tolerance = rates.at(name).at("tolerance");
  EXPECT_NEAR(observed, expected, tolerance) << name;
}

/// A line of test output in printf's format, from the first process only.
template <class... Values>
void report(const char* format, Values... values) {
  if constexpr (sizeof...(values) == 0) {
    petsc_check(PetscPrintf(PETSC_COMM_WORLD, "%s\n", format));
  } else {
    petsc_check(PetscPrintf(PETSC_COMM_WORLD, format, values...));
    petsc_check(PetscPrintf(PETSC_COMM_WORLD, "\n"));
  }
}

/// PETSc prints no stack of an error that is expected, for the time of a scope.
class ExpectedPetscErrors {
public:
  ExpectedPetscErrors() { petsc_check(PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr)); }
  ~ExpectedPetscErrors() { (void)PetscPopErrorHandler(); }
  ExpectedPetscErrors(const ExpectedPetscErrors&) = delete;
  ExpectedPetscErrors& operator=(const ExpectedPetscErrors&) = delete;
};

/// Message of the SolveError that a call raises; empty (and a failure) when it raises none.
template <class Call>
std::string solve_error_of(Call&& call) {
  const ExpectedPetscErrors quiet;
  try {
    call();
  } catch (const SolveError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no SolveError";
  return {};
}

}  // namespace gearfilm
