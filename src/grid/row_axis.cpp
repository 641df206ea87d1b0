#include "grid/row_axis.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gearfilm {
namespace {

constexpr double same_row = 1e-6;  // in steps

double rows_apart(const RowAxis& a, const RowAxis& b) { return (b.y(0) - a.y(0)) / a.equal_step(); }

/// The distance between rows, if it is the same between all.
std::optional<double> common_step(const std::vector<double>& y) {
  if (y.size() < 2) return {};
  const double step = (y.back() - y.front()) / static_cast<double>(y.size() - 1);
  for (std::size_t row = 1; row < y.size(); ++row) {
    if (std::abs(y[row] - y[row - 1] - step) > 1e-10 * step) return {};
  }
  return step;
}

}  // namespace

RowAxis::RowAxis(std::vector<double> y, Edge lower, Edge upper)
    : y_(std::move(y)), lower_(lower), upper_(upper), equal_step_(common_step(y_)) {
  const bool increasing = std::ranges::adjacent_find(y_, std::ranges::greater_equal()) == y_.end();
  if (y_.size() < 2 || !increasing || upper == Edge::symmetry || (mirrored() && y_.front() != 0.0)) {
    throw std::invalid_argument(
        "rows must be two or more, with increasing Y, an ambient upper edge, and symmetry in Y = 0 alone");
  }
}

// Either half is counted from its own end, so that rows on both sides of Y = 0 are mirror images to the bit.
RowAxis RowAxis::between(double first, double last, int count, Edge lower, Edge upper) {
  const double step = (last - first) / (count - 1);
  std::vector<double> y(std::max(0, count));
  for (int row = 0; row < count; ++row) {
    const bool from_first = lower == Edge::symmetry || 2 * row < count - 1;
    y[row] = from_first ? first + step * row : last - step * (count - 1 - row);
  }
  if (lower == Edge::ambient && count > 1 && count % 2 == 1 && first == -last) y[count / 2] = 0.0;
  if (count > 1) y.back() = last;
  return {std::move(y), lower, upper};
}

RowAxis RowAxis::equal(int whole, double half_width, Edge lower) {
  if (lower == Edge::symmetry) return between(0.0, half_width, (whole + 1) / 2, lower, Edge::ambient);
  return between(-half_width, half_width, whole, lower, Edge::ambient);
}

RowAxis RowAxis::line() {
  RowAxis axis;
  axis.y_ = {0.0};
  axis.lower_ = Edge::ambient;
  return axis;
}

double RowAxis::step(int row) const {
  if (equal_step_) return *equal_step_;
  if (single()) return 1.0;
  const int first = std::clamp(row, 0, count() - 2);
  return y_[first + 1] - y_[first];
}

double RowAxis::equal_step() const {
  if (!equal_step_) throw std::logic_error("rows at unequal distances have no common step");
  return *equal_step_;
}

RowRange RowAxis::inner(RowRange rows) const {
  if (single()) return rows;
  const int begin = std::max(rows.begin, mirrored() ? 0 : 1);
  return {begin, std::max(begin, std::min(rows.end, count() - 1))};
}

std::optional<int> RowAxis::distance_to_image(int row, int source) const {
  return mirrored() ? std::optional(row + source) : std::nullopt;
}

double RowAxis::weight(int row) const {
  const int images = mirrored() && row > 0 ? 2 : 1;
  return images * 0.5 * (step(row - 1) + step(row));
}

int RowAxis::nearest(double y) const {
  const auto row = std::ranges::min_element(y_, {}, [y](double own) { return std::abs(own - y); });
  return static_cast<int>(row - y_.begin());
}

double RowAxis::half_width() const { return mirrored() ? y_.back() : std::min(y_.back(), -y_.front()); }

int RowAxis::stored_row(int whole_row) const { return mirrored() ? std::abs(whole_row - (count() - 1)) : whole_row; }

double RowAxis::whole_y(int whole_row) const {
  const double y = y_[stored_row(whole_row)];
  return mirrored() && whole_row < count() - 1 ? -y : y;
}

bool RowAxis::can_coarsen() const { return has_equal_steps() && count() % 2 == 1 && (whole_count() - 1) / 2 + 1 >= 3; }

RowAxis RowAxis::coarsened() const {
  std::vector<double> y;
  for (int row = 0; row < count(); row += 2) y.push_back(y_[row]);
  return {std::move(y), lower_, upper_};
}

RowAxis RowAxis::refined() const {
  if (!equal_step_) return *this;
  return between(y_.front(), y_.back(), 2 * count() - 1, lower_, upper_);
}

RowAxis RowAxis::with_whole_count(int whole) const {
  return between(y_.front(), y_.back(), mirrored() ? (whole + 1) / 2 : whole, lower_, upper_);
}

RowAxis RowAxis::extended(int more) const {
  const double longer = more * equal_step();
  const int below = mirrored() ? 0 : more;
  return between(mirrored() ? 0.0 : y_.front() - longer, y_.back() + longer, below + count() + more, lower_, upper_);
}

bool same_lattice(const RowAxis& a, const RowAxis& b) {
  if (!a.has_equal_steps() || !b.has_equal_steps()) return a == b;
  const double rows = rows_apart(a, b);
  return a.lower() == b.lower() && a.upper() == b.upper() &&
         std::abs(a.equal_step() - b.equal_step()) <= 1e-9 * a.equal_step() &&
         std::abs(rows - std::round(rows)) < same_row;
}

int rows_between(const RowAxis& a, const RowAxis& b) {
  return a.has_equal_steps() ? static_cast<int>(std::lround(rows_apart(a, b))) : 0;
}

RowAxis enclosing(const RowAxis& a, const RowAxis& b) {
  if (!a.has_equal_steps()) return a;
  const int below = -rows_between(a, b), above = b.count() - a.count() - below;
  if (below >= 0 && above >= 0) return b;
  return std::max(below, above) > 0 ? a.extended(std::max(below, above)) : a;
}

}  // namespace gearfilm
