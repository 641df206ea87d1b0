#include "film/face_quantities.hpp"

#include <algorithm>
#include <cmath>

#include "film/face_flow.hpp"

namespace gearfilm {
namespace {

/// Out of the end beyond row `inner`, from there to row `end`, local both.
double flow_out(const ContactFilm& film, int inner, int end) {
  const Grid& grid = film.grid();
  const bool fitted = film.discretisation()->of_films() == FilmDiscretisation::fitted;
  const int lower = std::min(inner, end);
  const double step = std::abs(grid.row_axis().y(grid.y_begin() + end) - grid.row_axis().y(grid.y_begin() + inner));
  double sum = 0.0;
  for (int i = 1; i < grid.nx() - 1; ++i) {
    if (grid.x(i) <= -1.0) continue;
    const StateLine line(film.state(), i, FlowDirection::across);
    sum += fitted ? flow_along_y<FilmDiscretisation::fitted>(line, lower).value
                  : flow_along_y<FilmDiscretisation::central>(line, lower).value;
  }
  return (end > inner ? 1.0 : -1.0) * sum * grid.h_x() / step;
}

}  // namespace

double FaceQuantities::corner_film() const { return std::min(smallest_film.front(), smallest_film.back()); }

double FaceQuantities::smallest_film_beyond(double distance) const {
  double smallest = HUGE_VAL;
  for (std::size_t row = 0; row < Y.size(); ++row) {
    const bool beyond = Y[row] - Y.front() > distance && Y.back() - Y[row] > distance;
    if (beyond) smallest = std::min(smallest, smallest_film[row]);
  }
  return smallest;
}

int FaceQuantities::thinnest_row() const {
  const int left_out = corners_carry_films ? 0 : 1;
  const auto thinnest = std::ranges::min_element(smallest_film.begin() + left_out, smallest_film.end() - left_out);
  return static_cast<int>(thinnest - smallest_film.begin());
}

double FaceQuantities::smallest_film_at() const { return Y[thinnest_row()]; }

double FaceQuantities::film_between_rows() const {
  const int row = thinnest_row(), left_out = corners_carry_films ? 0 : 1;
  const int last = static_cast<int>(Y.size()) - 1 - left_out;
  double beside = HUGE_VAL;
  for (const int near : {row - 1, row + 1}) {
    if (near >= left_out && near <= last) beside = std::min(beside, smallest_film[near]);
  }
  return beside - smallest_film[row];
}

double FaceQuantities::largest_pressure_at() const {
  return Y[std::ranges::max_element(largest_pressure) - largest_pressure.begin()];
}

FaceQuantities face_quantities(const ContactFilm& film) {
  const Grid& grid = film.grid();
  const RowAxis& axis = grid.row_axis();
  enum { smallest, central, largest, load, count };
  // Own rows' values, and those of all rows.
  std::vector<double> rows(static_cast<std::size_t>(count) * grid.rows(), 0.0);
  const auto at = [&](int quantity, int row) -> double& {
    return rows[static_cast<std::size_t>(quantity) * grid.rows() + row];
  };
  // Linear between the lines beside X = 0, as the central film of a contact is.
  const double middle = -grid.x(0) / grid.h_x();
  const int before = std::clamp(static_cast<int>(middle), 0, grid.nx() - 2);
  for (int j = 0; j < grid.y_count(); ++j) {
    const int row = grid.y_begin() + j;
    at(smallest, row) = HUGE_VAL;
    at(central, row) = std::lerp(film.thickness().row(before)[j], film.thickness().row(before + 1)[j], middle - before);
    for (int i = 0; i < grid.nx(); ++i) {
      const double pressure = film.total_pressure().row(i)[j];
      at(smallest, row) = std::min(at(smallest, row), film.thickness().row(i)[j]);
      at(largest, row) = std::max(at(largest, row), pressure);
      at(load, row) += grid.h_x() * pressure;
    }
  }
  double flows[2] = {0.0, 0.0};
  for (int row = 0; row < axis.count(); ++row) {
    const int j = grid.local_row(row);
    if (j < 0 || !axis.is_ambient(row)) continue;
    row == 0 ? flows[0] = flow_out(film, 1, 0) : flows[1] = flow_out(film, j - 1, j);
  }
  MPI_Allreduce(MPI_IN_PLACE, rows.data(), static_cast<int>(rows.size()), MPI_DOUBLE, MPI_SUM, grid.comm());
  MPI_Allreduce(MPI_IN_PLACE, flows, 2, MPI_DOUBLE, MPI_SUM, grid.comm());
  FaceQuantities face;
  face.corners_carry_films = corners_carry_films(film.scales());
  for (int whole = 0; whole < axis.whole_count(); ++whole) {
    const int row = axis.stored_row(whole);
    face.Y.push_back(axis.whole_y(whole));
    face.smallest_film.push_back(at(smallest, row));
    face.central_film.push_back(at(central, row));
    face.largest_pressure.push_back(at(largest, row));
    face.line_load.push_back(at(load, row));
  }
  for (int row = 0; row < axis.count() && !axis.mirrored(); ++row) {
    if (!axis.is_ambient(row)) face.tilting_moment += axis.weight(row) * axis.y(row) * at(load, row);
  }
  face.side_flow_upper = flows[1];
  face.side_flow_lower = axis.mirrored() ? flows[1] : flows[0];
  return face;
}

}  // namespace gearfilm
