#include "elasticity/end_faces.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "elasticity/fftw.hpp"
#include "elasticity/love.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

/// f of the stress at depth z, for y >= 0.
double stress_corner(double x, double y, double z, double nu) {
  if (y == 0.0) return 0.0;  // both arcs tend to +-pi/2
  const double rho = std::sqrt(x * x + y * y + z * z);
  return -z * x * y / ((y * y + z * z) * rho) + 2.0 * nu * std::atan(x * y / (z * rho)) +
         (1.0 - 2.0 * nu) * (std::atan(x / y) - std::atan(z * x / (y * rho)));
}

/// Rows as one end sees them: nodes and edges of cells at their distances from it, the nearest first.
struct FromEnd {
  std::vector<double> nodes, edges;

  int rows() const { return static_cast<int>(nodes.size()); }
  double middle(int row) const { return 0.5 * (edges[row] + edges[row + 1]); }
};

/// Of the whole axis, mirror images included.
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

/// Even sequences of so many values, the distances 0, 1, ..., and their transforms, for all pairs of rows.
class EvenTransforms {
public:
  EvenTransforms(int rows, int count)
      : rows_(rows), count_(count), values_(static_cast<std::size_t>(rows) * rows * count) {
    const fftw_r2r_kind kind = FFTW_REDFT00;
    plan_ = fftw::Plan<double>(fftw_plan_many_r2r(1, &count_, rows * rows, values_.data(), nullptr, rows * rows, 1,
                                                  values_.data(), nullptr, rows * rows, 1, &kind, fftw::effort));
  }
  /// The matrix of a distance or a wave number, [target][source].
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> at(int k) {
    return {values_.data() + static_cast<std::size_t>(k) * rows_ * rows_, rows_, rows_};
  }
  void transform() { plan_.execute(); }

private:
  int rows_, count_;
  fftw::Buffer<double> values_;
  fftw::Plan<double> plan_;
};

/// Fills [distance][target][source] from a corner function of (x, edge of a source cell, target): differences over the
/// cells.
template <class Corner>
void fill_from_corners(EvenTransforms& transforms, const FromEnd& rows, int count, double h_x, Corner corner) {
  const int edges = rows.rows() + 1;
  std::vector<double> before(static_cast<std::size_t>(rows.rows()) * edges), behind(before);
  const auto find = [&](double x, std::vector<double>& corners) {
    for (int row = 0; row < rows.rows(); ++row) {
      for (int edge = 0; edge < edges; ++edge) corners[static_cast<std::size_t>(row) * edges + edge] = corner(x, edge, row);
    }
  };
  find(-0.5 * h_x, before);
  for (int lag = 0; lag < count; ++lag) {
    find((lag + 0.5) * h_x, behind);
    auto matrix = transforms.at(lag);
    for (int row = 0; row < rows.rows(); ++row) {
      const std::size_t first = static_cast<std::size_t>(row) * edges;
      for (int source = 0; source < rows.rows(); ++source) {
        matrix(row, source) = behind[first + source + 1] - behind[first + source] - before[first + source + 1] +
                              before[first + source];
      }
    }
    before.swap(behind);
  }
}

/// What an end adds under one body, [distance][target][source] in the order that the end sees.
void fill_free_end(EvenTransforms& added, const FromEnd& rows, int count, double h_x, double nu) {
  EvenTransforms& half_space = added;
  EvenTransforms image(rows.rows(), count), stress(rows.rows(), count);
  fill_from_corners(half_space, rows, count, h_x,
                    [&](double x, int edge, int row) { return love_corner(x, rows.edges[edge] - rows.nodes[row]); });
  fill_from_corners(image, rows, count, h_x,
                    [&](double x, int edge, int row) { return love_corner(x, rows.edges[edge] + rows.nodes[row]); });
  fill_from_corners(stress, rows, count, h_x, [&](double x, int edge, int row) {
    return stress_corner(x, rows.edges[edge], rows.middle(row), nu) / pi;
  });
  half_space.transform();
  image.transform();
  stress.transform();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(rows.rows(), rows.rows());
  const double scale = 1.0 / (2.0 * (count - 1));
  for (int k = 0; k < count; ++k) {
    const Eigen::MatrixXd S = stress.at(k), K = half_space.at(k), both = K + image.at(k);
    const Eigen::MatrixXd system = (identity - S * S).transpose();
    // (K + K_mirrored) (1 - S^2)^-1 - K
    added.at(k) = scale * (system.partialPivLu().solve(both.transpose()).transpose() - K);
  }
  added.transform();
}

/// The mirror image of the pressure times a factor.
void fill_mirror(EvenTransforms& added, const FromEnd& rows, int count, double h_x, double factor) {
  fill_from_corners(added, rows, count, h_x, [&](double x, int edge, int row) {
    return factor * love_corner(x, rows.edges[edge] + rows.nodes[row]);
  });
}

}  // namespace

// Periods of the transforms are four times the padded length: images of a load that is so far away bend nothing.
EndFaceCompliance::EndFaceCompliance(const GridShape& shape, const EndFaces& ends)
    : rows_(shape.rows()),
      lags_(shape.nx),
      values_(static_cast<std::size_t>(rows_) * rows_ * lags_, 0.0) {
  const RowAxis& axis = shape.row_axis;
  const int whole = axis.whole_count(), count = 4 * fftw::fast_length(shape.nx, true) + 1;
  const auto add = [&](bool upper, double share, EvenTransforms& added) {
    const auto seen = [&](int whole_row) { return upper ? whole - 1 - whole_row : whole_row; };
    for (int i = 0; i < lags_; ++i) {
      const auto matrix = added.at(i);
      for (int row = 0; row < rows_; ++row) {
        const int target = seen(axis.mirrored() ? row + rows_ - 1 : row);
        for (int source = 0; source < whole; ++source) {
          values_[(static_cast<std::size_t>(row) * rows_ + axis.stored_row(source)) * lags_ + i] +=
              share * matrix(target, seen(source));
        }
      }
    }
  };
  const auto add_end = [&](bool upper, auto fill, double share, int lags) {
    EvenTransforms added(whole, lags);
    fill(added, from_end(axis, upper));
    add(upper, share, added);
    // Rows that are their own mirror image look alike from both ends.
    if (axis.mirrored()) add(!upper, share, added);
  };
  for (const bool upper : {true, false}) {
    if (!upper && axis.mirrored()) continue;
    if (ends.kind == EndFace::mirror) {
      const auto fill = [&](EvenTransforms& added, const FromEnd& rows) {
        fill_mirror(added, rows, lags_, shape.h_x(), ends.mirror_factor);
      };
      add_end(upper, fill, 1.0, lags_ + 1);
    }
    if (ends.kind != EndFace::free) continue;
    for (const EndingBody& body : ends.bodies) {
      const auto fill = [&](EvenTransforms& added, const FromEnd& rows) {
        fill_free_end(added, rows, count, shape.h_x(), body.poisson_ratio);
      };
      add_end(upper, fill, body.share, count);
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
