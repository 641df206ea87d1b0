#include "elasticity/row_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "algebra/dense.hpp"
#include "gearfilm/error.hpp"
#include "lubricant/independent_iterations.hpp"
#include "lubricant/vector_math.hpp"

namespace gearfilm {
namespace {

using std::numbers::pi;

constexpr double narrowest = 1e-6;  // half-width of a row without load [a]

constexpr int nodes_of_finest = 256;  // of a quadrature

/// Nodes and weights of (1 - xi^2)^(1/2) in 2/pi on [-1, 1].
struct Quadrature {
  explicit Quadrature(int count) {
    for (int n = 1; n <= count; ++n) {
      const double angle = pi * n / (count + 1), sine = std::sin(angle);
      nodes.push_back(std::cos(angle));
      weights.push_back(2.0 * sine * sine / (count + 1));
    }
  }
  std::vector<double> nodes, weights;
};

/// Enough nodes for what changes within `length` over a width of two.
const Quadrature& quadrature_for(double length) {
  static const std::vector<Quadrature> all = [] {
    std::vector<Quadrature> list;
    for (int count = 4; count <= nodes_of_finest; count *= 2) list.emplace_back(count);
    return list;
  }();
  std::size_t n = 0;
  for (double resolved = 2.0; resolved > length && n + 1 < all.size(); resolved *= 0.5) ++n;
  return all[n];
}

}  // namespace

RowContact::RowContact(const Scales& scales, const RowAxis& rows) : rows_(rows), C_h_(scales.C_h) {
  for (int row = 0; row < rows.count(); ++row) {
    const double y = rows.y(row);
    gaps_.push_back(0.5 * scales.radius_ratio * y * y + (*scales.solids.face)(y * scales.length) / scales.thickness);
    weights_.push_back(rows.is_ambient(row) ? 0.0 : rows.weight(row));
  }
  const int whole = rows.whole_count();
  for (int n = 0; n < whole; ++n) {
    const double y = rows.whole_y(n);
    const double before = n > 0 ? 0.5 * (rows.whole_y(n - 1) + y) : y;
    const double behind = n + 1 < whole ? 0.5 * (rows.whole_y(n + 1) + y) : y;
    whole_.push_back({y, before, behind, rows.stored_row(n)});
  }
  const auto count = static_cast<std::size_t>(rows.count());
  end_influence_.assign(count * count, 0.0);
  middle_ = edge_ = end_influence_;
  half_widths_.assign(count, 1.0);
  loaded_.assign(count, false);
}

// Beneath rows of the static half-width.
void RowContact::add_ends(const EndFaceCompliance& ends, double h_x) {
  const auto count = static_cast<std::size_t>(rows_.count());
  const int half = std::min(ends.lags() - 1, static_cast<int>(1.0 / h_x));
  double sum = 0.0;
  std::vector<double> pressure;
  for (int i = 0; i <= half; ++i) {
    const double x = i * h_x;
    pressure.push_back((i == 0 ? 1.0 : 2.0) * std::sqrt(std::max(0.0, 1.0 - x * x)));
    sum += pressure.back() * h_x;
  }
  for (int row = 0; row < rows_.count(); ++row) {
    for (int source = 0; source < rows_.count(); ++source) {
      double& influence = end_influence_[static_cast<std::size_t>(row) * count + source];
      for (int i = 0; i <= half; ++i) influence += pressure[i] / sum * ends(i, row, source);
    }
  }
}

// Unit pressure on a line across a row, from Y = lower to Y = upper and at the distance d along X, deforms a place by
// asinh(upper/d) - asinh(lower/d). In the own row its part 2 ln d is integrated exactly: -2 (ln(s/2) - 1/2 + x^2/s^2).
double RowContact::influence(double at_x, double at_y, const Place& source, bool own, double s,
                             std::span<double> values) {
  const double upper = source.upper - at_y, lower = source.lower - at_y;
  const double near = std::min(std::abs(upper), std::abs(lower)), far = std::max(std::abs(upper), std::abs(lower));
  const Quadrature& rule = quadrature_for(near / s);
  const std::size_t count = rule.nodes.size();
  GEARFILM_INDEPENDENT_ITERATIONS
  for (std::size_t n = 0; n < count; ++n) {
    const double d = std::max(std::abs(at_x - s * rule.nodes[n]), 1e-12 * s);
    const double of_far = far + std::sqrt(far * far + d * d), of_near = near + std::sqrt(near * near + d * d);
    values[n] = rule.weights[n] * log(own ? of_far * of_near : of_far / of_near);
  }
  const double sum = std::accumulate(values.begin(), values.begin() + count, 0.0);
  return own ? sum - 2.0 * (log(0.5 * s) - 0.5 + (at_x / s) * (at_x / s)) : sum;
}

void RowContact::find_influence() {
  const int count = rows_.count();
  std::array<double, nodes_of_finest> values{};
  std::ranges::fill(middle_, 0.0);
  std::ranges::fill(edge_, 0.0);
  for (int row = 0; row < count; ++row) {
    const double y = rows_.y(row);
    for (const Place& source : whole_) {
      const double s = half_widths_[source.stored];
      if (rows_.is_ambient(source.stored)) continue;
      const bool own = source.y == y;
      const std::size_t at = static_cast<std::size_t>(row) * count + source.stored;
      middle_[at] += C_h_ * influence(0.0, y, source, own, s, values);
      if (half_widths_[row] > narrowest) edge_[at] += C_h_ * influence(half_widths_[row], y, source, own, s, values);
    }
    for (int source = 0; source < count; ++source) {
      const std::size_t at = static_cast<std::size_t>(row) * count + source;
      middle_[at] += C_h_ * end_influence_[at];
      edge_[at] += C_h_ * end_influence_[at];
    }
  }
}

// Rows that pull are let go; those that penetrate are taken in again by follow_edges().
double RowContact::balance(double force) {
  const auto count = static_cast<std::size_t>(rows_.count());
  for (int round = 0; round <= rows_.count(); ++round) {
    std::vector<std::size_t> set;
    for (std::size_t row = 0; row < count; ++row) {
      if (loaded_[row]) set.push_back(row);
    }
    const auto size = static_cast<Eigen::Index>(set.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size + 1, size + 1);
    Eigen::VectorXd right(size + 1);
    for (Eigen::Index r = 0; r < size; ++r) {
      for (Eigen::Index c = 0; c < size; ++c) matrix(r, c) = middle_[set[r] * count + set[c]];
      matrix(r, size) = -1.0;
      matrix(size, r) = weights_[set[r]];
      right[r] = -gaps_[set[r]];
    }
    right[size] = force;
    const Eigen::VectorXd found = solved(matrix, right);
    loads_.assign(count, 0.0);
    bool pulls = false;
    for (Eigen::Index r = 0; r < size; ++r) {
      loads_[set[r]] = std::max(0.0, found[r]);
      if (found[r] >= 0.0) continue;
      loaded_[set[r]] = false;
      pulls = true;
    }
    if (!pulls) return found[size];
  }
  throw SolveError("no row of the face carries its dry contact");
}

double RowContact::follow_edges(double force, double approach, double relative_radius, double share) {
  const auto count = static_cast<std::size_t>(rows_.count());
  double change = 0.0;
  for (std::size_t row = 0; row < count; ++row) {
    if (rows_.is_ambient(static_cast<int>(row))) continue;
    double sinking = 0.0, gap = gaps_[row] - approach;
    for (std::size_t source = 0; source < count; ++source) {
      const std::size_t at = row * count + source;
      sinking += (middle_[at] - edge_[at]) * loads_[source];
      gap += middle_[at] * loads_[source];
    }
    double& half_width = half_widths_[row];
    if (!loaded_[row]) {
      loaded_[row] = gap < 0.0;  // and then narrow at first
      half_width = loaded_[row] ? std::max(half_width, 0.1 * std::sqrt(force / rows_.half_width())) : narrowest;
      continue;
    }
    const double wanted = std::sqrt(std::max(2.0 * relative_radius * sinking, narrowest * narrowest));
    const double before = half_width > narrowest ? half_width : wanted;
    change = std::max(change, std::abs(wanted - before) * weights_[row] / rows_.half_width());
    half_width = std::max(0.5 * before, std::lerp(before, wanted, share));
  }
  return change;
}

// Beside the ends dry pressures are numbers of the rows; they count where no other row is loaded.
std::vector<int> RowContact::counting_rows() const {
  std::vector<int> rows;
  for (const double clear : {1.0, 0.0}) {
    for (int row = 0; row < rows_.count(); ++row) {
      if (rows_.half_width() - std::abs(rows_.y(row)) >= clear && loads_[row] != 0.0) rows.push_back(row);
    }
    if (!rows.empty()) break;
  }
  return rows;
}

double RowContact::most_loaded_place() const {
  const std::vector<int> rows = counting_rows();
  return rows_.y(*std::ranges::max_element(rows, {}, [&](int row) { return loads_[row]; }));
}

// s^2 falls to zero as a straight line does, as at the tip of an ellipse, but before the next row.
std::vector<ContactEnd> RowContact::ends_within() const {
  std::vector<ContactEnd> ends;
  const int count = rows_.count();
  const auto loaded = [&](int row) { return row >= 0 && row < count && loads_[row] > 0.0; };
  for (const int out : {-1, 1}) {
    for (int row = 0; row < count; ++row) {
      const int next = row + out;
      if (!loaded(row) || loaded(next) || next < 0 || rows_.is_ambient(next)) continue;
      const double square = half_widths_[row] * half_widths_[row], y = rows_.y(row);
      double widening = square / std::abs(rows_.y(next) - y);
      for (int inner = row - out; loaded(inner) && std::abs(inner - row) <= 2; inner -= out) {
        const double rise = half_widths_[inner] * half_widths_[inner] - square;
        widening = std::max(widening, rise / std::abs(rows_.y(inner) - y));
      }
      ends.push_back({.y = y + out * square / widening, .widening = widening});
    }
  }
  return ends;
}

Strip RowContact::reached() const {
  const int last = rows_.count() - 1;
  int upper = last, lower = 0;
  while (upper > 0 && loads_[upper - 1] == 0.0) --upper;
  while (lower < last && loads_[lower + 1] == 0.0) ++lower;
  const double to = rows_.y(upper) + 1.0;
  return rows_.mirrored() ? Strip{-to, to} : Strip{rows_.y(lower) - 1.0, to};
}

FaceContact RowContact::found(double force, double approach) const {
  FaceContact contact{.force = force, .approach = approach};
  double moment = 0.0;
  for (const int row : counting_rows()) {
    contact.half_width = std::max(contact.half_width, half_widths_[row]);
    contact.pressure = std::max(contact.pressure, 2.0 * loads_[row] / (pi * half_widths_[row]));
  }
  for (int row = 0; row < rows_.count() && !rows_.mirrored(); ++row) {
    moment += weights_[row] * rows_.y(row) * loads_[row];
  }
  contact.arm = moment / force;
  return contact;
}

void RowContact::begin_anew() { std::ranges::fill(half_widths_, 1.0); }

// All of the way to the edges at first, and half of it where half-widths swing.
FaceContact RowContact::solve(double force, double relative_radius, double settled) {
  constexpr int most_turns = 100;
  for (int row = 0; row < rows_.count(); ++row) loaded_[row] = !rows_.is_ambient(row);
  double share = 1.0, last_change = HUGE_VAL;
  for (int turn = 0; turn < most_turns; ++turn) {
    find_influence();
    const double approach = balance(force);
    const double change = follow_edges(force, approach, relative_radius, share);
    if (turn > 2 && change < settled) return found(force, approach);
    if (change > 0.7 * last_change) share = 0.5;
    last_change = change;
  }
  throw SolveError("the dry contact along the face is not found");
}

double RowContact::loaded_width() const {
  double sum = 0.0;
  for (std::size_t row = 0; row < loads_.size(); ++row) sum += loads_[row] > 0.0 ? weights_[row] : 0.0;
  return sum;
}

namespace {

/// Where pressures at the ends act on the end faces: lines over a little more than the contact.
GridShape shape_of_ends(const RowAxis& rows) {
  constexpr int lines = 49;
  constexpr double reach = 1.5;
  return {lines, -reach, reach, rows};
}

std::optional<EndFaceCompliance> compliance_of_ends(const Face& face, const GridShape& shape) {
  const EndFaces ends = ends_of(face);
  return ends.act() ? std::optional(EndFaceCompliance(shape, ends)) : std::nullopt;
}

double half_width_of(const Scales& scales) { return 0.5 * scales.solids.face->width / scales.length; }

}  // namespace

RowGrading coarse_grading(const Scales& scales) {
  return {
      .first = 0.1, .kink = 0.3, .bend = 0.3, .growth = 1.6, .largest = std::max(1.25, half_width_of(scales) / 12.0)};
}

RowGrading fine_grading(const Scales& scales) {
  return {
      .first = 0.06, .kink = 0.2, .bend = 0.2, .growth = 1.4, .largest = std::max(1.25, half_width_of(scales) / 32.0)};
}

FaceRows::FaceRows(const Face& face, const RowGrading& grading, double a)
    : rows_(rows_over_face(face, grading, a)),
      ends_(compliance_of_ends(face, shape_of_ends(rows_))),
      h_x_(shape_of_ends(rows_).h_x()) {}

RowContact FaceRows::contact(const Scales& scales) const {
  RowContact contact(scales, rows_);
  if (ends_) contact.add_ends(*ends_, h_x_);
  return contact;
}

LoadedFace loaded_face(const Scales& scales, std::span<const double> forces, const RowGrading& grading) {
  const RowAxis rows = rows_over_face(*scales.solids.face, grading, scales.length);
  RowContact contact(scales, rows);
  LoadedFace face;
  for (const double force : forces) {
    contact.solve(force, 1.0);
    const std::vector<ContactEnd> ends = contact.ends_within();
    face.ends.insert(face.ends.end(), ends.begin(), ends.end());
    if (rows.mirrored()) {
      for (const ContactEnd& end : ends) face.ends.push_back({-end.y, end.widening});
    }
    if (force == forces.front()) face.reached = contact.reached();
  }
  return face;
}

double most_loaded_place(const Scales& scales, double force, double relative_radius) {
  RowContact contact = FaceRows(*scales.solids.face, coarse_grading(scales), scales.length).contact(scales);
  contact.solve(force, relative_radius);
  return contact.most_loaded_place();
}

FaceLaw face_law(const Scales& scales, std::array<double, 2> relative_radii) {
  constexpr double smallest = 0.01, largest = 8.0;  // of the static force
  constexpr int points = 12;
  RowContact contact = FaceRows(*scales.solids.face, fine_grading(scales), scales.length).contact(scales);
  std::array<std::vector<FaceContact>, 2> contacts;
  for (std::size_t radius = 0; radius < 2; ++radius) {
    for (int n = points; n-- > 0;) {
      const double ratio = smallest * std::pow(largest / smallest, n / (points - 1.0));
      contacts[radius].insert(contacts[radius].begin(),
                              contact.solve(ratio * scales.static_force, relative_radii[radius]));
    }
  }
  return {contact.nearest(), relative_radii, contacts};
}

}  // namespace gearfilm
