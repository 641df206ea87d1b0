#include "film/reynolds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "film/face_flow.hpp"
#include "lubricant/independent_iterations.hpp"
#include "parallel/events.hpp"

namespace gearfilm {
namespace {

constexpr double carrying_share = 0.2;  // c of face_flow.hpp

/// What flows through the faces of one line's cells, from process to process the same.
template <FilmDiscretisation discretisation, class Line, bool with_rates>
class CellFlows {
public:
  CellFlows(const ReynoldsEquation& equation, const FilmState& state)
      : equation_(equation),
        state_(state),
        rows_(equation.grid.y_count()),
        west_(rows_),
        east_(rows_),
        across_(rows_ + 1) {
    find_along_x(0);
  }

  /// Adds to every row what flows out of the cells of line i; lines in their order, from the first inner one on.
  void add(int i, double* line) {
    west_.swap(east_);
    find_along_x(i);
    find_along_y(i);
    const double *west = west_.data(), *east = east_.data(), *face = across_.data();
    const double *to_south = equation_.south.data(), *to_north = equation_.north.data();
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < rows_; ++j) line[j] += east[j] - west[j] + to_north[j] * face[j + 1] - to_south[j] * face[j];
  }

private:
  void find_along_x(int i) {
    const FlowAlongX<discretisation, Line, with_rates> flow(equation_, state_, i);
    double* east = east_.data();
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < rows_; ++j) east[j] = flow.at(j).value;
  }
  void find_along_y(int i) {
    const Line line(state_, i, FlowDirection::across);
    double* face = across_.data();
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j <= rows_; ++j) face[j] = flow_along_y<discretisation>(line, j - 1).value;
  }

  const ReynoldsEquation& equation_;
  const FilmState& state_;
  int rows_;
  std::vector<double> west_, east_;  ///< along X, through the faces before and behind the cells of the line, over h_x
  std::vector<double> across_;       ///< along Y, through the face before each row and behind the last
};

/// Where oil is pushed over the front of a full region, it goes as far as what it meets has room for: nodes there, full
/// or not by themselves, are full. By itself the front would come forward by one node an iteration. A node is at the
/// front where no pressure in it drives oil away; between rough surfaces, where P_f = P - P_a is never zero to the last
/// bit, where less is driven away than comes in.
void advance_fronts(const Grid& grid, FilmState& state, std::span<double> residual) {
  const RowRange rows = grid.inner_rows();
  const double driven = state.rough ? 1.0 : 0.0;  // of what comes in
  const auto sweep = [&](int first, int last, int way) {
    std::vector<double> pushed(grid.y_count(), 0.0);
    for (int i = first; i != last; i += way) {
      const double *pressure = state.film_pressure().row(i), *behind = state.film_pressure().row(i - way);
      const double* scale = state.row_scale.row(i);
      double* full_film = state.full_film.row(i);
      const double* line = residual.data() + static_cast<std::ptrdiff_t>(i) * grid.y_count();
      double* over = pushed.data();
      GEARFILM_INDEPENDENT_ITERATIONS
      for (int j = rows.begin; j < rows.end; ++j) {
        const bool empty = scale[j] * pressure[j] <= driven * std::abs(line[j]);
        const bool front = empty & (line[j] < 0.0) & (behind[j] > 0.0);
        const bool filled = empty & (line[j] >= 0.0) & (line[j] <= over[j]);
        const double left = filled ? over[j] - line[j] : 0.0;
        full_film[j] = filled ? 1.0 : full_film[j];
        over[j] = front ? -line[j] : left;
      }
    }
  };
  sweep(1, grid.nx() - 1, 1);
  sweep(grid.nx() - 2, 0, -1);
}

}  // namespace

ReynoldsEquation::ReynoldsEquation(const Grid& on_grid, double C_h, FilmDiscretisation of_films)
    : grid(on_grid),
      discretisation(of_films),
      inverse_h_x(1.0 / grid.h_x()),
      inverse_h_x2(inverse_h_x * inverse_h_x),
      carrying(carrying_share * grid.h_x() * grid.h_x() * 2.0 * std::numbers::pi * C_h) {
  for (int j = 0; j < grid.y_count(); ++j) {
    const double before = grid.row_axis().step(grid.y_begin() + j - 1),
                 after = grid.row_axis().step(grid.y_begin() + j);
    const double width = 0.5 * (before + after), across = grid.row_axis().single() ? 0.0 : 1.0;
    south.push_back(across / (width * before));
    north.push_back(across / (width * after));
  }
}

namespace {

/// R of the own inner nodes, with the scales of rows and the nodes that are full by themselves.
template <FilmDiscretisation discretisation, class Line, bool with_rates>
void find_rows(const ReynoldsEquation& equation, std::span<const double> U, FilmState& state, const Squeeze& squeeze,
               std::span<double> residual) {
  const Grid& grid = equation.grid;
  const int rows = grid.y_count();
  const RowRange inner = grid.inner_rows();
  CellFlows<discretisation, Line, with_rates> flows(equation, state);
  for (int i = 0; i < grid.nx(); ++i) {
    const bool interior = i > 0 && i < grid.nx() - 1;
    const Line line(state, i);
    double *full_film = state.full_film.row(i), *scale = state.row_scale.row(i);
    double* out = residual.data() + static_cast<std::size_t>(i) * rows;
    if (interior) {
      std::copy_n(state.rate.row(i), rows, out);
    } else {
      std::fill_n(out, rows, 0.0);
    }
    if (interior) flows.add(i, out);
    const double oil = state.without_oil ? 0.0 : 1.0, inside = interior ? oil : 0.0, *speed = U.data();
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < rows; ++j) {
      const double row_scale = equation.row_scale(j, oil * line.conductance(j), speed[j], squeeze.shift);
      scale[j] = row_scale;
      full_film[j] = out[j] < row_scale * line.p[j] ? inside : 0.0;
    }
    std::fill(full_film, full_film + inner.begin, 0.0);
    std::fill(full_film + inner.end, full_film + rows, 0.0);
  }
}

}  // namespace

void reynolds_residual(const ReynoldsEquation& equation, std::span<const double> entrainment, FilmState& state,
                       const Squeeze& squeeze, std::span<double> residual) {
  const ScopedEvent event(Kernel::residual);
  if (squeeze.rate.empty()) {
    state.rate.fill(0.0);
  } else {
    state.rate.load(squeeze.rate);
  }
  with_kinds(equation, state, [&]<FilmDiscretisation discretisation, class Line, bool with_rates>() {
    find_rows<discretisation, Line, with_rates>(equation, entrainment, state, squeeze, residual);
  });
  const Grid& grid = equation.grid;
  if (!state.without_oil) advance_fronts(grid, state, residual);
  for (int i = 0; i < grid.nx(); ++i) {
    const double *pressure = state.film_pressure().row(i), *full_film = state.full_film.row(i),
                 *scale = state.row_scale.row(i);
    double* out = residual.data() + static_cast<std::size_t>(i) * grid.y_count();
    GEARFILM_INDEPENDENT_ITERATIONS
    for (int j = 0; j < grid.y_count(); ++j) {
      const double given = out[j], dry = scale[j] * pressure[j];
      out[j] = full_film[j] != 0.0 ? given : dry;
    }
  }
}

void poiseuille_flow(const ReynoldsEquation& equation, const FilmState& state, int i, std::span<double> flow) {
  std::ranges::fill(flow, 0.0);
  if (i == 0 || i == equation.grid.nx() - 1) return;
  const StateLine west(state, i - 1), line(state, i), east(state, i + 1);
  const double half_inverse_h_x = 0.5 * equation.inverse_h_x;
  const int rows = equation.grid.y_count();
  double* out = flow.data();
  const auto of_node = [&](int j) {
    return -half_inverse_h_x * line.conductance(j) / line.rho[j] * (east.p[j] - west.p[j]);
  };
  if (equation.discretisation == FilmDiscretisation::central) {
    for (int j = 0; j < rows; ++j) out[j] = of_node(j);
    return;
  }
  const FlowAlongX<FilmDiscretisation::fitted> before(equation, state, i - 1), behind(equation, state, i);
  GEARFILM_INDEPENDENT_ITERATIONS
  for (int j = 0; j < rows; ++j) {
    const double through_faces = 0.5 * (before.driven(j) + behind.driven(j)), own = of_node(j);
    const double smaller = std::abs(own) < std::abs(through_faces) ? own : through_faces;
    out[j] = own * through_faces > 0.0 ? smaller : 0.0;
  }
}

}  // namespace gearfilm
