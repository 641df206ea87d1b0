// A section through a body below a row of a film: its lines along x, and the stresses there at some depths.
#pragma once

#include "grid/grid.hpp"
#include "stress/strip_spectra.hpp"

namespace gearfilm {

/// Lines of a section at the step of a grid, those of the grid among them. In a.
struct SectionLines {
  /// As far as the grid, and at least `reach` to either side of x = 0.
  SectionLines(const GridShape& shape, double reach);

  double x(int line) const { return first + step * line; }
  /// For loads on the grid's lines, without anything that comes round from the other end.
  StripLattice lattice() const;

  double step;
  int of_grid;  ///< lines that the grid has
  int before;   ///< lines before those of the grid
  int count;
  double first;
};

/// Stresses of one body at the lines of a section and the depths that a process keeps.
class SectionStress {
public:
  SectionStress() = default;
  SectionStress(int depths, int lines)
      : depths_(depths), lines_(lines), values_(stress_components * static_cast<std::size_t>(depths) * lines, 0.0) {}

  int lines() const { return lines_; }
  int depths() const { return depths_; }
  /// A component at all lines.
  std::span<double> line_of(int depth, std::size_t component) {
    return std::span(values_).subspan((depth * stress_components + component) * lines_, lines_);
  }
  std::span<const double> line_of(int depth, std::size_t component) const {
    return std::span(values_).subspan((depth * stress_components + component) * lines_, lines_);
  }
  Stress at(int depth, int line) const {
    const auto value = [&](std::size_t component) { return line_of(depth, component)[line]; };
    return {value(0), value(1), value(2), value(3), value(4), value(5)};
  }

private:
  int depths_ = 0;
  int lines_ = 0;
  std::vector<double> values_;  ///< [depth][component][line]
};

}  // namespace gearfilm
