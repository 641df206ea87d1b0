#include "elasticity/end_faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "algebra/dense.hpp"
#include "elasticity/fftw.hpp"
#include "elasticity/love.hpp"
#include "lubricant/independent_iterations.hpp"
#include "lubricant/vector_math.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

/// f of the stress at depth z, for y >= 0; at y = 0 both arcs of the last term are +-pi/2.
double stress_corner(double x, double y, double z, double nu) {
  const double rho = std::sqrt(x * x + y * y + z * z);
  return -z * x * y / ((y * y + z * z) * rho) + 2.0 * nu * atan(x * y / (z * rho)) +
         (1.0 - 2.0 * nu) * (atan(x / y) - atan(z * x / (y * rho)));
}

/// Rows as one end sees them: nodes and edges of cells at their distances from it, the nearest first.
struct FromEnd {
  std::vector<double> nodes, edges;

  int rows() const { return static_cast<int>(nodes.size()); }

  /// But for round-off.
  bool same_as(const FromEnd& other) const {
    const double most = 1e-12 * edges.back();
    return std::ranges::equal(nodes, other.nodes, [most](double a, double b) { return std::abs(a - b) <= most; });
  }
};

/// The rows of the whole axis, mirror images included, as its upper or its lower end sees them.
FromEnd from_end(const RowAxis& axis, bool upper) {
  const int count = axis.whole_count();
  const auto distance = [&](int row) {
    const int last = count - 1;
    return upper ? axis.whole_y(last) - axis.whole_y(last - row) : axis.whole_y(row) - axis.whole_y(0);
  };
  FromEnd seen;
  for (int row = 0; row < count; ++row) {
    seen.nodes.push_back(distance(row));
    seen.edges.push_back(row == 0 ? 0.0 : 0.5 * (distance(row - 1) + distance(row)));
  }
  seen.edges.push_back(distance(count - 1));
  return seen;
}

/// Cells of rows cut into parts that grow by a third with the distance from the end, where p' changes that fast, and
/// the rows to which they belong.
struct FineCells {
  explicit FineCells(const FromEnd& rows) {
    constexpr double growth = 1.35;
    double smallest = 0.1 * rows.edges[1];
    for (int row = 0; row < rows.rows(); ++row) {
      std::vector<double> inner;  // from the far edge to the near one
      double edge = rows.edges[row + 1] / growth;
      while (edge > std::max(rows.edges[row] * std::sqrt(growth), smallest)) {
        inner.push_back(edge);
        edge /= growth;
      }
      edges.insert(edges.end(), inner.rbegin(), inner.rend());
      edges.push_back(rows.edges[row + 1]);
      row_of.resize(edges.size() - 1, row);
    }
  }
  int count() const { return static_cast<int>(row_of.size()); }
  double middle(int cell) const { return 0.5 * (edges[cell] + edges[cell + 1]); }

  std::vector<double> edges = {0.0};
  std::vector<int> row_of;
};

/// Even sequences of so many values, the distances 0, 1, ..., and their transforms, for all targets and sources.
class EvenTransforms {
public:
  EvenTransforms(int targets, int sources, int count)
      : targets_(targets),
        sources_(sources),
        count_(count),
        values_(static_cast<std::size_t>(targets) * sources * count) {
    const fftw_r2r_kind kind = FFTW_REDFT00;
    const int pairs = targets * sources;
    plan_ = fftw::Plan<double>(fftw_plan_many_r2r(1, &count_, pairs, values_.data(), nullptr, pairs, 1, values_.data(),
                                                  nullptr, pairs, 1, &kind, fftw::effort));
  }
  int targets() const { return targets_; }
  int sources() const { return sources_; }
  /// The matrix of a distance or a wave number, [target][source].
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> at(int k) {
    return {values_.data() + static_cast<std::size_t>(k) * targets_ * sources_, targets_, sources_};
  }
  void transform() { plan_.execute(); }

private:
  int targets_, sources_, count_;
  fftw::Buffer<double> values_;
  fftw::Plan<double> plan_;
};

/// Fills [distance][target][source] from a corner function of (x, edge of a source cell, target): differences over the
/// cells.
template <class Corner>
void fill_from_corners(EvenTransforms& transforms, int count, double h_x, Corner corner) {
  const int rows = transforms.targets(), edges = transforms.sources() + 1;
  std::vector<double> before(static_cast<std::size_t>(rows) * edges), behind(before);
  const auto find = [&](double x, std::vector<double>& corners) {
    for (int row = 0; row < rows; ++row) {
      double* of_row = &corners[static_cast<std::size_t>(row) * edges];
      GEARFILM_INDEPENDENT_ITERATIONS
      for (int edge = 0; edge < edges; ++edge) of_row[edge] = corner(x, edge, row);
    }
  };
  find(-0.5 * h_x, before);
  for (int lag = 0; lag < count; ++lag) {
    find((lag + 0.5) * h_x, behind);
    auto matrix = transforms.at(lag);
    for (int row = 0; row < rows; ++row) {
      const std::size_t first = static_cast<std::size_t>(row) * edges;
      for (int source = 0; source + 1 < edges; ++source) {
        matrix(row, source) =
            behind[first + source + 1] - behind[first + source] - before[first + source + 1] + before[first + source];
      }
    }
    before.swap(behind);
  }
}

/// What an end adds under one body, [distance][target][source] in the order that the end sees.
void fill_free_end(EvenTransforms& added, const FromEnd& rows, int count, double h_x, double nu) {
  const FineCells cells(rows);
  EvenTransforms both(rows.rows(), cells.count(), count), stress(cells.count(), cells.count(), count);
  fill_from_corners(added, count, h_x,
                    [&](double x, int edge, int row) { return love_corner(x, rows.edges[edge] - rows.nodes[row]); });
  fill_from_corners(both, count, h_x, [&](double x, int edge, int row) {
    return love_corner(x, cells.edges[edge] - rows.nodes[row]) + love_corner(x, cells.edges[edge] + rows.nodes[row]);
  });
  fill_from_corners(stress, count, h_x, [&](double x, int edge, int cell) {
    return stress_corner(x, cells.edges[edge], cells.middle(cell), nu) / pi;
  });
  for (EvenTransforms* kernel : {&added, &both, &stress}) kernel->transform();
  Eigen::MatrixXd of_rows = Eigen::MatrixXd::Zero(cells.count(), rows.rows());  // the same pressure on all parts
  for (int cell = 0; cell < cells.count(); ++cell) of_rows(cell, cells.row_of[cell]) = 1.0;
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(cells.count(), cells.count());
  const double scale = 1.0 / (2.0 * (count - 1));
  for (int k = 0; k < count; ++k) {
    // (K + K_mirrored) (1 - S^2)^-1 - K, with 1 - S^2 = (1 - S) (1 + S)
    const Eigen::MatrixXd S = stress.at(k), half_way = LuFactors(identity - S).solve_columns(of_rows);
    added.at(k) = scale * (both.at(k) * LuFactors(identity + S).solve_columns(half_way) - added.at(k));
  }
  added.transform();
}

/// The mirror image of the pressure times a factor.
void fill_mirror(EvenTransforms& added, const FromEnd& rows, int count, double h_x, double factor) {
  fill_from_corners(added, count, h_x, [&](double x, int edge, int row) {
    return factor * love_corner(x, rows.edges[edge] + rows.nodes[row]);
  });
}

/// Adds what an end adds, in the order that it sees, to values of stored rows, [target][source][distance].
void add_seen_from_end(const RowAxis& axis, bool upper, double share, int lags, EvenTransforms& added,
                       std::vector<double>& values) {
  const int rows = axis.count(), whole = axis.whole_count();
  const auto seen = [&](int whole_row) { return upper ? whole - 1 - whole_row : whole_row; };
  for (int i = 0; i < lags; ++i) {
    const auto matrix = added.at(i);
    for (int row = 0; row < rows; ++row) {
      const int target = seen(axis.mirrored() ? row + rows - 1 : row);
      for (int source = 0; source < whole; ++source) {
        values[(static_cast<std::size_t>(row) * rows + axis.stored_row(source)) * lags + i] +=
            share * matrix(target, seen(source));
      }
    }
  }
}

}  // namespace

EndFaces ends_of(const Face& face) { return {face.end, face.ending, face.mirror_factor}; }

// Periods of the transforms are four times the padded length: images of a load that is so far away bend nothing.
EndFaceCompliance::EndFaceCompliance(const GridShape& shape, const EndFaces& ends)
    : rows_(shape.rows()), lags_(shape.nx), values_(static_cast<std::size_t>(rows_) * rows_ * lags_, 0.0) {
  const RowAxis& axis = shape.row_axis;
  const int whole = axis.whole_count(), count = 4 * fftw::fast_length(shape.nx) + 1;
  const FromEnd upper = from_end(axis, true), lower = from_end(axis, false);
  const bool alike = upper.same_as(lower);
  const auto add_both_ends = [&](int lags, double share, auto fill) {
    EvenTransforms added(whole, whole, lags);
    fill(added, upper);
    add_seen_from_end(axis, true, share, lags_, added, values_);
    if (!alike) fill(added, lower);
    add_seen_from_end(axis, false, share, lags_, added, values_);
  };
  if (ends.kind == EndFace::mirror) {
    add_both_ends(lags_ + 1, 1.0, [&](EvenTransforms& added, const FromEnd& rows) {
      fill_mirror(added, rows, lags_, shape.h_x(), ends.mirror_factor);
    });
  }
  if (ends.kind == EndFace::free) {
    std::map<double, double> shares;  // by Poisson's ratio
    for (const EndingBody& body : ends.bodies) shares[body.poisson_ratio] += body.share;
    for (const std::pair<const double, double>& body : shares) {
      add_both_ends(count, body.second, [&](EvenTransforms& added, const FromEnd& rows) {
        fill_free_end(added, rows, count, shape.h_x(), body.first);
      });
    }
  }
  leave_out_rigid_part(shape);
}

// Beneath the half-ellipse of a line contact of the half-width 1.
void EndFaceCompliance::leave_out_rigid_part(const GridShape& shape) {
  const RowAxis& axis = shape.row_axis;
  double displaced = 0.0, load = 0.0, width = 0.0;
  const int reach = std::min(lags_ - 1, static_cast<int>(1.0 / shape.h_x()));
  // Rows at the ends stand for half a strip.
  const auto width_of = [&](int row) { return (axis.is_ambient(row) ? 0.5 : 1.0) * axis.weight(row); };
  for (int row = 0; row < rows_; ++row) width += width_of(row);
  for (int i = -reach; i <= reach; ++i) {
    const double x = i * shape.h_x(), pressure = std::sqrt(std::max(0.0, 1.0 - x * x));
    load += pressure * shape.h_x() * width;
    for (int row = 0; row < rows_; ++row) {
      double sum = 0.0;
      for (int source = 0; source < rows_; ++source) sum += (*this)(std::abs(i), row, source);
      displaced += width_of(row) / width * pressure * sum;
    }
  }
  const double by_force = displaced / load;
  for (int row = 0; row < rows_; ++row) {
    for (int source = 0; source < rows_; ++source) {
      double* values = &values_[(static_cast<std::size_t>(row) * rows_ + source) * lags_];
      for (int i = 0; i < lags_; ++i) values[i] -= by_force * shape.h_x() * width_of(source);
    }
  }
}

}  // namespace gearfilm
