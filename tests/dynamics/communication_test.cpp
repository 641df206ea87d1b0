// What travels between processes: the model of docs/performance.md against PETSc's counters.
#include "elasticity/dense_y_convolution.hpp"
#include "pair_case.hpp"
#include "traction/traction.hpp"

namespace gearfilm {
namespace {

/// Sums over all processes.
struct Traffic {
  double messages = 0.0;  ///< between neighbours
  double message_bytes = 0.0;
  double collectives = 0.0;  ///< reductions, broadcasts, transposes; one a process
  double transposed_bytes = 0.0;

  friend Traffic operator+(const Traffic& a, const Traffic& b) {
    return {a.messages + b.messages, a.message_bytes + b.message_bytes, a.collectives + b.collectives,
            a.transposed_bytes + b.transposed_bytes};
  }
  friend Traffic operator*(double factor, const Traffic& a) {
    return {factor * a.messages, factor * a.message_bytes, factor * a.collectives, factor * a.transposed_bytes};
  }
};

/// Of this process so far.
Traffic counted() { return {petsc_isend_ct, petsc_isend_len, petsc_allreduce_ct, petsc_send_len}; }

template <class Call>
Traffic traffic_of(Call&& call) {
  const Traffic before = counted();
  call();
  Traffic traffic = counted() + -1.0 * before;
  MPI_Allreduce(MPI_IN_PLACE, &traffic, 4, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return traffic;
}

void expect_equal(const Traffic& counted, const Traffic& model) {
  EXPECT_EQ(counted.messages, model.messages);
  EXPECT_EQ(counted.message_bytes, model.message_bytes);
  EXPECT_EQ(counted.collectives, model.collectives);
  EXPECT_EQ(counted.transposed_bytes, model.transposed_bytes);
}

/// Two contacts on one level, as time steps have them.
class Communication : public testing::Test {
protected:
  // Of a grid of nx lines, with W wave numbers in x, and R rows.
  Traffic halo(int fields, double bytes) const {
    const double messages = 2.0 * (processes - 1);
    return {messages, messages * fields * grid.nx() * bytes, 0.0, 0.0};
  }
  // Few rows go to all others, in pieces; many are transposed, and back.
  Traffic convolution(double bytes, const Grid& on) const {
    if (processes == 1) return {};
    const int waves = LineTransforms<float>::fast_length(2 * on.nx() - 3) / 2 + 1;
    const double spectra = 2.0 * waves * on.rows() * bytes;
    if (!DenseYConvolution<float>::serve(waves, on.rows())) return {0.0, 0.0, 2.0 * processes, 2.0 * spectra};
    const int largest = (on.rows() + on.processes() - 1) / on.processes();
    const int pieces = bytes == in_single ? DenseYConvolution<float>::pieces(waves, largest)
                                          : DenseYConvolution<double>::pieces(waves, largest);
    return {processes * (processes - 1) * pieces, (processes - 1) * spectra, 0.0, 0.0};
  }
  Traffic convolution(double bytes) const { return convolution(bytes, grid); }
  Traffic collective() const { return {0.0, 0.0, processes == 1 ? 0.0 : processes, 0.0}; }
  Traffic krylov_iteration() const {
    const Traffic product = convolution(in_single) + halo(2, in_single), sweep = halo(1, in_single);
    return 5.0 * collective() + 2.0 * (product + sweep);
  }

  static constexpr double in_single = sizeof(float), in_double = sizeof(double);
  const CaseInput problem = table3_case({{"grid.nx", "65"},
                                         {"grid.ny", "33"},
                                         {"friction.law", "eyring"},
                                         {"thermal.model", "film"},
                                         {"lubricant.temperature_viscosity", "0.04"}});
  const MeshModel mesh = mesh_of(problem);
  const Grid grid{PETSC_COMM_WORLD, case_grid(problem)};
  const double processes = grid.processes();
  const SharedDiscretisation shared = discretise(grid, problem);
  ContactFilm first{shared, problem.scales, {.levels = 1}}, second{shared, problem.scales, {.levels = 1}};
  LubricatedPair pair{mesh, {{0, &first}, {1, &second}}};
  FilmSystem& films = pair.system();
};

TEST_F(Communication, of_ghosts_and_of_a_convolution_is_the_model) {
  Field<float> single_field(grid);
  Field<double> one(grid), other(grid);
  const Halo ghosts(grid);
  const auto exchange = [&] {
    ghosts.exchange(single_field);
    ghosts.exchange(one, other);
  };
  exchange();  // the first one sets up its messages
  expect_equal(traffic_of(exchange), halo(1, in_single) + halo(2, in_double));
  const Grid many_rows(PETSC_COMM_WORLD, rectangle(65, 129, -2.0, 1.25, 1.1));
  for (const Grid* on : {&grid, &many_rows}) {
    const Deformation<float> deformation(*on, 1.0);
    Field<float> field(*on), deformed(*on);
    expect_equal(traffic_of([&] { deformation.apply(field, deformed); }), convolution(in_single, *on));
  }
}

TEST_F(Communication, of_a_residual_and_a_krylov_iteration_is_the_model) {
  const double shift = 1.5 / problem.numerics.steps.dT;
  OwnedVec state = films.create_state(), rate = films.create_state(), rows = films.create_state();
  std::vector<double> pressure(grid.local_size());
  hertz_pressure(grid, problem.scales, problem.scales.hertz, pressure);
  const auto residual_at = [&](double H0) {
    for (std::size_t k = 0; k < 2; ++k) films.set_field(state, k, pressure);
    pair.set_motion(state, {H0, 0.0});
    return traffic_of([&] { films.residual(state, {rate, shift}, rows); });
  };
  pair.place(0.0);
  residual_at(-1.4);
  // The motion and the force carried; film, ghosts of seven fields.
  expect_equal(residual_at(-1.5), 2.0 * collective() + 2.0 * (convolution(in_double) + halo(7, in_double)));

  // The motion: the state is known to be the one of the residual.
  expect_equal(traffic_of([&] { pair.linearise(state, {rate, shift}, shift); }), collective());
  const OwnedMat jacobian = shell_jacobian(films);
  OwnedKSP solver;
  petsc_check(KSPCreate(PETSC_COMM_WORLD, solver.put()));
  petsc_check(KSPSetOperators(solver, jacobian, jacobian));
  const auto iterations = [&](int count) {
    configure_krylov(solver, films, 1e-30, count);
    return traffic_of([&] { petsc_check(KSPSolve(solver, rows, state)); });
  };
  iterations(4);
  expect_equal(iterations(9) + -1.0 * iterations(4), 5.0 * krylov_iteration());
}

// Oil and heat go along the lines, which are whole: films that feel their heat send no more in a residual than others.
TEST_F(Communication, of_heat_is_sums_alone) {
  std::vector<double> pressure(grid.local_size()), rows(grid.local_size());
  hertz_pressure(grid, problem.scales, problem.scales.hertz, pressure);
  FilmHeat heat;
  const auto sweep = [&] { coupled_traction(*mesh.traction, first, heat, {}); };
  pair.place(0.5);
  first.residual(pressure, 0.5, {}, rows);
  sweep();
  first.set_flow_factors(heat.flow);
  // Film, ghosts of seven fields.
  expect_equal(traffic_of([&] { first.residual(pressure, 0.5, {}, rows); }),
               convolution(in_double) + halo(7, in_double));
  // Integrals, largest values, missed temperatures, whether all have found theirs.
  expect_equal(traffic_of(sweep), 4.0 * collective());
}

}  // namespace
}  // namespace gearfilm
