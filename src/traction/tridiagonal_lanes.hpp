// Tridiagonal equations of some places side by side, for several right sides.
//
//   d_k x_k - b_k x_(k-1) - a_k x_(k+1) = r_k
// Gauss from both ends to the middle, and out again: two chains of divisions that wait for themselves but not for each
// other.
#pragma once

#include <array>
#include <vector>

#include "traction/film_lanes.hpp"

namespace gearfilm {

/// Solves in place, an odd number of rows, at least three; the diagonal is lost.
template <std::size_t sides>
void solve_tridiagonal(const std::vector<FilmLanes>& below, const std::vector<FilmLanes>& above,
                       std::vector<FilmLanes>& diagonal, const std::array<std::vector<FilmLanes>*, sides>& right) {
  const int last = static_cast<int>(diagonal.size()) - 1, middle = last / 2;
  const auto invert = [&](int k) { each_lane([&](int l) { diagonal[k][l] = 1.0 / diagonal[k][l]; }); };
  // Takes a neighbour out of row k, by what connects them in their rows.
  const auto fold = [&](int k, int neighbour, const FilmLanes& here, const FilmLanes& there) {
    FilmLanes factor;
    each_lane([&](int l) {
      factor[l] = here[l] * diagonal[neighbour][l];
      diagonal[k][l] -= factor[l] * there[l];
    });
    for (std::vector<FilmLanes>* side : right) {
      each_lane([&](int l) { (*side)[k][l] += factor[l] * (*side)[neighbour][l]; });
    }
  };
  const auto put_in = [&](int k, int neighbour, const FilmLanes& here) {
    for (std::vector<FilmLanes>* side : right) {
      each_lane([&](int l) { (*side)[k][l] = ((*side)[k][l] + here[l] * (*side)[neighbour][l]) * diagonal[k][l]; });
    }
  };
  invert(0);
  invert(last);
  for (int n = 1; n < middle; ++n) {
    const int k = last - n;
    fold(n, n - 1, below[n], above[n - 1]);
    fold(k, k + 1, above[k], below[k + 1]);
    invert(n);
    invert(k);
  }
  fold(middle, middle - 1, below[middle], above[middle - 1]);
  fold(middle, middle + 1, above[middle], below[middle + 1]);
  invert(middle);
  for (std::vector<FilmLanes>* side : right) each_lane([&](int l) { (*side)[middle][l] *= diagonal[middle][l]; });
  for (int n = middle - 1; n >= 0; --n) {
    const int k = last - n;
    put_in(n, n + 1, above[n]);
    put_in(k, k - 1, below[k]);
  }
}

}  // namespace gearfilm
